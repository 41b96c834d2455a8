cat > actions.json <<'END'
{"format": "uhas-solution", "version": 1, "actions": []}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: is not a file of actions: no "format": "uhas-actions"; see schemas/actions.schema.json
