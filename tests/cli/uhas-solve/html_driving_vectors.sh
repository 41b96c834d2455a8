cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "driving_vectors_phi": [1, 2, 1, 2, 1, 2, 1, 2, 1.1, 2], "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]]}
END
uhas-solve actions.json --html report.html
