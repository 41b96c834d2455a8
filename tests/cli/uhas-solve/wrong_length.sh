cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0], [1, 2]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: action 1: has 2 numbers; write 5 + 5 V numbers for V = 1 to 4 driving vectors, 15 for the usual two
