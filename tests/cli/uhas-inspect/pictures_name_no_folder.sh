# nothing of the machine gets into a page or a picture
uhas-inspect profile/allegro_right.h5 --urdf hand/allegro_right.urdf --html hand.html --gltf hand.glb --ply hand.ply --svg hand.svg --quiet
for folder in "$PWD" "$(realpath hand)"; do grep -c "$folder" hand.html hand.glb hand.ply hand.svg; done
exit 0
#> hand.html:0
#> hand.glb:0
#> hand.ply:0
#> hand.svg:0
#> hand.html:0
#> hand.glb:0
#> hand.ply:0
#> hand.svg:0
