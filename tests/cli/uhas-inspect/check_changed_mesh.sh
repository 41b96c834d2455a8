cp -rL hand copy
echo "# changed" >> copy/meshes/palm.obj
uhas-inspect profile/allegro_right.h5 --check copy/allegro_right.urdf
