uhas-project-surface hand/allegro_right.urdf -o no/such/folder/points.json
