echo '[0,0,0,0,0, 0,0,0,0,0]' | uhas-solve - --profile profile/allegro_right.h5 --avoid
#? 1
#2> uhas-solve: error: profile/allegro_right.h5: self-collision needs the hand's meshes, and the URDF that it was built from is neither beside it nor here; name it with --urdf
