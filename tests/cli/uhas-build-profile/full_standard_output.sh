uhas-build-profile hand/allegro_right.urdf -o hand.h5 > /dev/full
#? 1
#2> uhas-build-profile: error: standard output: cannot be written; free some space
