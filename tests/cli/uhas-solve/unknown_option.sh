uhas-solve actions.json --jsno
