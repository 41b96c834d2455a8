uhas-build-profile hand/allegro_right.urdf --quiet --verbose
