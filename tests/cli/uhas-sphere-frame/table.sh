uhas-sphere-frame hand/allegro_right.urdf
