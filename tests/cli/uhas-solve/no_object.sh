cat > actions.json <<'END'
[1, 2, 3]
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
