/usr/bin/python3 -c '
import json
names = [f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]
document = {"format": "uhas-trajectory", "version": 1, "joint_names": names, "q": [[0.4] * 16]}
document["hand"] = "allegro_left"
json.dump(document, open("t.json", "w"))'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.json -o out.json > /dev/null
code=$?
ls out.json 2> /dev/null
exit $code
#> out.json
#2> uhas-retarget: warning: the trajectory is of allegro_left, the profile of --from is of allegro_right
