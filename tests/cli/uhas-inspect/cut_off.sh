# a file cut off while it was copied is refused by its length, before HDF5 sees it
head -c 1000 profile/allegro_right.h5 > cut.h5
uhas-inspect cut.h5
