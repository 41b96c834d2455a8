uhas-inspect profile/allegro_right.h5 -g fingers.4.name
#? 1
#2> uhas-inspect: error: there is no value fingers.4.name; fingers holds 0 to 3
