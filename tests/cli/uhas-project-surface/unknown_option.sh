uhas-project-surface hand/allegro_right.urdf --jsno
