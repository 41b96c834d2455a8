uhas-project-surface hand/allegro_right.urdf | head -n 2
