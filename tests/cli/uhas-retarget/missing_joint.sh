/usr/bin/python3 -c '
import json
names = [f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]
document = {"format": "uhas-trajectory", "version": 1, "joint_names": names, "q": [[0.4] * 16]}
document["joint_names"] = names[2:]
json.dump(document, open("t.json", "w"))'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.json -o out.json
code=$?
ls out.json 2> /dev/null
exit $code
#? 1
#2> uhas-retarget: error: t.json: joint_names lacks joints of allegro_right: index_joint_0, index_joint_1; add them; only joints that mimic others may be left out
