uhas-inspect profile/allegro_right.h5 profile/allegro_right.h5
#? 2
#2> uhas-inspect: error: profile.h5: several profiles are for --html alone; see uhas-inspect --help
