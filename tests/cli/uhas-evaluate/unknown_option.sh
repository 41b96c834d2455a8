uhas-evaluate profile/allegro_right.h5 --no-such-option
#? 2
#2> uhas-evaluate: error: The following argument was not expected: --no-such-option; see uhas-evaluate --help
