cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "convention": "uhas-sim", "actions": [[0,0,0,0,0, 1,1, 1,1, 1,1, 1,1, 1,1]]}
END
uhas-solve actions.json --html report.html
code=$?
test ! -e report.html && exit $code
#? 2
#2> uhas-solve: error: --html: shows actions of uhas' own convention only; see uhas-solve --help
