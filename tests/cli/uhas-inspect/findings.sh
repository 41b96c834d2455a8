uhas-inspect profile/allegro_right.h5 --findings | tail -n 10
