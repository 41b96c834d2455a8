# the thumb turns into the palm; the other action is kept
echo '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0,0, 0,0,0,0,-2], [0,0,0,0,0, 0,0,0,0,0.1]]}' > actions.json
uhas-solve actions.json --profile profile/allegro_right.h5 --avoid --collisions --urdf hand/allegro_right.urdf > solution.json
grep -o '"scaled": 0.[0-9]\|"scaled": 1.0\|"colliding": [a-z]*' solution.json
#> "scaled": 0.4
#> "colliding": false
#> "scaled": 1.0
#> "colliding": false
#2> uhas-solve: warning: scaled back 1 of 2 actions: the hand would collide with itself
