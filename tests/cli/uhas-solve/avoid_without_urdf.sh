echo '[0,0,0,0,0, 0,0,0,0,0]' | uhas-solve - --profile profile/allegro_right.h5 --avoid
