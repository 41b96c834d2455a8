cat > actions.json <<'END'
{"format": "uhas-actions", "version": 2, "actions": []}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json: version is 2, this tool reads 1; write "version": 1
