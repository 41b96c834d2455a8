uhas-inspect profile/allegro_right.h5 profile/allegro_right.h5
