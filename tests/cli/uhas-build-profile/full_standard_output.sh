uhas-build-profile hand/allegro_right.urdf -o hand.h5 > /dev/full
