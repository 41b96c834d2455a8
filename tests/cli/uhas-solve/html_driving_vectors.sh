# driving vectors of each plane's own, without a model
cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "driving_vectors_phi": [0.8, 1, 1.2, 1.4, 1.6], "actions": [[0,0,0,0,0, -1,-1,-1,-1,-1]]}
END
uhas-solve actions.json -o solution.json --html report.html
grep -o '"driving_vectors_phi":[^}]*' report.html | cut -d, -f1-5
#> "driving_vectors_phi":[0.8,1.0,1.2,1.4,1.6]
#2> uhas-solve: warning: profile/allegro_right.h5: its model is not here, so the picture lacks the meshes; name the URDF with --urdf
