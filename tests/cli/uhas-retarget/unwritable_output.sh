/usr/bin/python3 -c '
import json
names = [f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]
document = {"format": "uhas-trajectory", "version": 1, "joint_names": names, "q": [[0.4] * 16]}

json.dump(document, open("t.json", "w"))'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.json -o no/such/folder.json
#? 1
#2> uhas-retarget: error: no/such/folder.json: no file can be made in its folder: No such file or directory; check the folder, its permissions and the free space
