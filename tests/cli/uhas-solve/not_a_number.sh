cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5",
 "actions": [[NaN]]}
END
uhas-solve actions.json -o solution.json
code=$?
test ! -e solution.json && exit $code
#? 1
#2> uhas-solve: error: actions.json:2: not JSON: syntax error while parsing value - invalid literal; last read: '"actions": [[N'; correct the syntax
