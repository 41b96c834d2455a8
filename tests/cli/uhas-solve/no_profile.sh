echo '{"format": "uhas-actions", "version": 1, "actions": []}' > actions.json
uhas-solve actions.json
