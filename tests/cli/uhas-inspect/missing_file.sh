uhas-inspect profile/missing.h5
#? 1
#2> uhas-inspect: error: profile/missing.h5: the file does not exist; check the path
