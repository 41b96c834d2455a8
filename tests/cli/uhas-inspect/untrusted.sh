# the same words with the fence as without, of a sound profile and of a damaged one
uhas-inspect profile/allegro_right.h5 --json > plain.json
uhas-inspect profile/allegro_right.h5 --json --untrusted > fenced.json && cmp plain.json fenced.json
head -c 1000 profile/allegro_right.h5 > cut.h5
uhas-inspect cut.h5 --untrusted
