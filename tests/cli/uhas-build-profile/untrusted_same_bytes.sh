# the fence changes no byte
uhas-build-profile --quiet --untrusted hand/allegro_right.urdf && cmp allegro_right.h5 profile/allegro_right.h5
