uhas-inspect profile/allegro_right.h5 --urdf hand/allegro_right.urdf --gltf hand.glb --ply points.ply --svg tables.svg
head -c 4 hand.glb; echo
grep 'element vertex' points.ply
grep -c '<polyline' tables.svg
#> Wrote hand.glb
#> Wrote points.ply
#> Wrote tables.svg
#> glTF
#> element vertex 3136
#> 4
