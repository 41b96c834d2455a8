uhas-inspect profile/allegro_right.h5 --jsno
#? 2
#2> uhas-inspect: error: The following argument was not expected: --jsno; see uhas-inspect --help
