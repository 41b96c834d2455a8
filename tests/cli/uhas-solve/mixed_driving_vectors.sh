cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0], [0,0,0,0,0, 0,0,0,0,0]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: action 1: has 10 numbers, not 15; give all actions of a file the same number of driving vectors
