# a file cut off while it was copied is refused by its length, before HDF5 sees it
head -c 1000 profile/allegro_right.h5 > cut.h5
uhas-inspect cut.h5
#? 1
#2> uhas-inspect: error: cut.h5: the file is truncated: it has 1000 bytes of 326752; rebuild it with uhas-build-profile
