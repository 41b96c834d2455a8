cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,"1"]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: action 0: element 14 is "1"; write a number
