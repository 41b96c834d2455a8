uhas-evaluate profile/missing.h5
