echo '{"format": "uhas-actions", "version": 1, "profile": "missing.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]]}' > actions.json
uhas-solve actions.json --profile profile/allegro_right.h5 | grep '"hand"'
uhas-solve actions.json
#? 1
#>   "hand": "allegro_right",
#2> uhas-solve: error: missing.h5: the file does not exist; check the path
