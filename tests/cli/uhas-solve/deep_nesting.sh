/usr/bin/python3 -c "print('[' * 1000000)" > actions.json
uhas-solve actions.json
