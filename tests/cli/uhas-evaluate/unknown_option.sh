uhas-evaluate profile/allegro_right.h5 --no-such-option
