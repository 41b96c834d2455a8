uhas-evaluate profile/allegro_right.h5 --actions 0
