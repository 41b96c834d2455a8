echo '[0,0,0,0,0, 0,0,0,0,0]' | uhas-solve - --profile profile/allegro_right.h5 --collisions --urdf "$(readlink -f hand)/../allegro_left/allegro_left.urdf" 2> message
code=$?
sed 's|[^ ]*/allegro_left.urdf|allegro_left.urdf|' message >&2
exit $code
#? 1
#2> uhas-solve: error: allegro_left.urdf: is not what profile/allegro_right.h5 was built from; name the same URDF, or see uhas-inspect --check for what has changed
