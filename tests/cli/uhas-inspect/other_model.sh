# stderr: the other model is refused
uhas-inspect profile/allegro_right.h5 --gltf hand.glb --urdf hand/../leap_right/leap_right.urdf
test ! -e hand.glb
#2> uhas-inspect: error: hand/../leap_right/leap_right.urdf: is not what profile/allegro_right.h5 was built from; name the same URDF, or see uhas-inspect --check for what has changed
