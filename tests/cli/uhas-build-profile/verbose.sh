# stderr: --verbose says what is done
uhas-build-profile hand/allegro_right.urdf --verbose -o hand.h5 > /dev/null
