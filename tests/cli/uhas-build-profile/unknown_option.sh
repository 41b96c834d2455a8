uhas-build-profile hand/allegro_right.urdf --jsno
