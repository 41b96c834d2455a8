uhas-inspect profile/allegro_right.h5 --urdf hand/allegro_right.urdf
