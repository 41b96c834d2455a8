cp -rL hand copy
echo "# changed" >> copy/meshes/palm.obj
uhas-inspect profile/allegro_right.h5 --check copy/allegro_right.urdf
#? 1
#> check                       result  found
#> allegro_right.urdf          ok      unchanged
#> meshes/palm.obj             FAILED  changed
#> meshes/finger_base.obj      ok      unchanged
#> meshes/finger_proximal.obj  ok      unchanged
#> meshes/finger_middle.obj    ok      unchanged
#> meshes/finger_distal.obj    ok      unchanged
#> meshes/fingertip.obj        ok      unchanged
#> meshes/thumb_mount.obj      ok      unchanged
#> meshes/thumb_base.obj       ok      unchanged
#> meshes/thumb_proximal.obj   ok      unchanged
#> meshes/thumb_distal.obj     ok      unchanged
#2> uhas-inspect: error: profile/allegro_right.h5: check failed: meshes/palm.obj (changed); rebuild it with uhas-build-profile
