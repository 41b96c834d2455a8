uhas-inspect
#? 2
#2> uhas-inspect: error: profile.h5 is required; see uhas-inspect --help
