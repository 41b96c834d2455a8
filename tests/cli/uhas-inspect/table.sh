uhas-inspect profile/allegro_right.h5 | head -n 5
