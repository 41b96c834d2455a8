uhas-solve actions.json --profile profile/allegro_right.h5 --urdf hand/allegro_right.urdf
