echo '{"format": "uhas-actions", "version": 1, "actions": []}' > actions.json
uhas-solve actions.json
#? 2
#2> uhas-solve: error: --profile: needed because actions.json does not name a hand profile; see uhas-solve --help
