head -c 100000 profile/allegro_right.h5 > hand.h5
uhas-inspect hand.h5
