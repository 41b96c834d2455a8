uhas-inspect profile/allegro_right.h5 -g radius
