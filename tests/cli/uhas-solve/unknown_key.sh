cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "action": []}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
