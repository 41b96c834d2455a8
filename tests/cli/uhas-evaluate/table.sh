uhas-evaluate profile/allegro_right.h5 --urdf hand/allegro_right.urdf --actions 40 --lines 10 | grep -v '^time'
