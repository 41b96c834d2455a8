uhas-inspect profile/allegro_right.h5 --gltf hand.glb
#> Wrote hand.glb
#2> uhas-inspect: warning: profile/allegro_right.h5: its model is not here, so the picture lacks the meshes; name the URDF with --urdf
