cp -rL hand copy && mv copy/allegro_right.urdf copy/hand.urdf
uhas-inspect profile/allegro_right.h5 --check copy/hand.urdf --json | grep '"passed"' | sort | uniq -c | tail -n 1 | grep -c true
#> 1
