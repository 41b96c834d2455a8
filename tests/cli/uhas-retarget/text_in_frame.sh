/usr/bin/python3 -c '
import json
names = [f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]
document = {"format": "uhas-trajectory", "version": 1, "joint_names": names, "q": [[0.4] * 16]}
document["q"].append([0.4] * 15 + ["0.4"])
json.dump(document, open("t.json", "w"))'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.json -o out.json
code=$?
ls out.json 2> /dev/null
exit $code
#? 1
#2> uhas-retarget: error: t.json: frame 1: is not a frame; write an array of numbers, or {"q": [numbers]}
