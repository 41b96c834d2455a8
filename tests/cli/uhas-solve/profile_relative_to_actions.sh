echo '{"format": "uhas-actions", "version": 1, "profile": "allegro_right.h5", "actions": []}' > profile/actions.json
uhas-solve profile/actions.json
