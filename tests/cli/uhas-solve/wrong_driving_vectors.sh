cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "driving_vectors_phi": [2, 1], "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: action 0: driving-vector angles must increase strictly within (0, pi)
