uhas-project-surface hand/allegro_right.urdf --samples 0
