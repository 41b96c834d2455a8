set -e
actions() { echo '{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "convention": "'$1'", "actions": [['$2']]}' > actions.json; }
# radii of 1 with the rule and the closing of uhas are its zero action; the option wins over the file
actions uhas 0,0,0,0,0,0,0,0,0,0,0,0,0,0,0
uhas-solve actions.json > zero.json
actions uhas-sim 0,0,0,0,0,1,1,1,1,1,1,1,1,1,1
uhas-solve actions.json --rule correspondence --closing fade | cmp zero.json -
uhas-solve actions.json --convention uhas > displaced.json
if cmp -s zero.json displaced.json; then exit 1; fi
# by itself the convention solves by contact and closes hard
uhas-solve actions.json > sim.json
uhas-solve actions.json --rule contact --closing hard | cmp sim.json -
# a stream has no file to name it
echo '[0,0,0,0,0, 1,1,1,1,1,1,1,1,1,1]' | uhas-solve - --profile profile/allegro_right.h5 --convention uhas-sim > stream.json
echo '[0,0,0,0,0, 1,1,1,1,1,1,1,1,1,1]' | uhas-solve - --profile profile/allegro_right.h5 > stream_uhas.json
if cmp -s stream.json stream_uhas.json; then exit 1; fi
