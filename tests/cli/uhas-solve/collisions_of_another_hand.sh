echo '[0,0,0,0,0, 0,0,0,0,0]' | uhas-solve - --profile profile/allegro_right.h5 --collisions --urdf "$(readlink -f hand)/../allegro_left/allegro_left.urdf" 2> message
code=$?
sed 's|[^ ]*/allegro_left.urdf|allegro_left.urdf|' message >&2
exit $code
