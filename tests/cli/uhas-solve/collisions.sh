# free with room to spare; in contact, where the distance is 0
echo '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0,0, 0,0,0,0,0], [0,0,0,0,0, 0,0,0,0,-2]]}' > actions.json
uhas-solve actions.json --profile profile/allegro_right.h5 --collisions --urdf hand/allegro_right.urdf > solution.json
sed -n 's/\("distance": 0\.0[0-9]\{4\}\)[0-9]*/\1/; s/.*"collision": //p' solution.json
#> {"distance": 0.01891, "pair": ["index_link_1", "middle_link_1"], "colliding": false}
#> {"distance": 0.0, "pair": ["palm", "thumb_link_3"], "colliding": true}
