uhas-evaluate profile/missing.h5
#? 1
#2> uhas-evaluate: error: profile/missing.h5: the file does not exist; check the path
