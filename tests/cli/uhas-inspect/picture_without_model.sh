uhas-inspect profile/allegro_right.h5 --gltf hand.glb
