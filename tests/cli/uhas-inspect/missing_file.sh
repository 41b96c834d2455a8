uhas-inspect profile/missing.h5
