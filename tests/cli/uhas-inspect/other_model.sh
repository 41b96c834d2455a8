# stderr: the other model is refused
uhas-inspect profile/allegro_right.h5 --gltf hand.glb --urdf hand/../leap_right/leap_right.urdf
test ! -e hand.glb
