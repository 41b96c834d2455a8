uhas-build-profile hand/allegro_right.urdf --package NAME
