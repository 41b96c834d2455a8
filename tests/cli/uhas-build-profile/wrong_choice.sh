uhas-build-profile hand/allegro_right.urdf --geometry visuals
