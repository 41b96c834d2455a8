uhas-inspect profile/allegro_right.h5 --check hand/allegro_right.urdf
