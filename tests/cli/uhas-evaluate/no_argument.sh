uhas-evaluate
#? 2
#2> uhas-evaluate: error: profile.h5 is required; see uhas-evaluate --help
