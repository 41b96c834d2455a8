# a URDF of the right name and bytes beside the profile is the model
cp profile/allegro_right.h5 . && cp -r hand/. . && uhas-inspect allegro_right.h5 --gltf hand.glb
#> Wrote hand.glb
