cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0], [1, 2]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
