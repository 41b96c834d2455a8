uhas-build-profile hand/allegro_right.urdf --radius-scale 1.1 --samples 2000 --points-per-link 8 --lateral-steps 51 --geometry both --json -o a.h5 > a.json
uhas-inspect a.h5 --json > b.json && cmp a.json b.json
