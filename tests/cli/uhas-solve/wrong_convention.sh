echo '{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "convention": "isaac", "actions": []}' > actions.json
uhas-solve actions.json
#? 1
#2> uhas-solve: error: actions.json: convention is "isaac"; write "uhas" or "uhas-sim"
