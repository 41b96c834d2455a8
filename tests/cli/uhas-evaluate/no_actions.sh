uhas-evaluate profile/allegro_right.h5 --actions 0
#? 2
#2> uhas-evaluate: error: --actions: Value 0 not in range 1 to 1000000; see uhas-evaluate --help
