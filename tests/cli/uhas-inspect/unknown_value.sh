uhas-inspect profile/allegro_right.h5 -g fingers.4.name
