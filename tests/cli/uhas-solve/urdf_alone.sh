uhas-solve actions.json --profile profile/allegro_right.h5 --urdf hand/allegro_right.urdf
#? 2
#2> uhas-solve: error: --urdf: needs --collisions, --avoid or --html; see uhas-solve --help
