# two profiles of one hand, one of a smaller sphere
uhas-build-profile hand/allegro_right.urdf -o small.h5 --radius-scale 0.8 --quiet > log
uhas-evaluate profile/allegro_right.h5 small.h5 --urdf hand/allegro_right.urdf --urdf hand/allegro_right.urdf --actions 20 --lines 5 | grep -v '^time'
