/usr/bin/python3 -c "print('[' * 1000000)" > actions.json
uhas-solve actions.json
#? 1
#2> uhas-solve: error: actions.json: nested more than 16 levels deep; use fewer levels
