uhas-inspect profile/allegro_right.h5 --urdf hand/allegro_right.urdf
#? 2
#2> uhas-inspect: error: --urdf: needs --html or --gltf; see uhas-inspect --help
