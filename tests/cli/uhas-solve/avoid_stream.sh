# the model lies beside the profile; a line that cannot be solved is counted for nothing
cp -r hand/allegro_right.urdf hand/meshes profile
printf '%s\n' '[0,0,0,0,0, 0,0,0,0,-2]' '[1, 2]' '[0,0,0,0,0, 0,0,0,0,0.1]' | uhas-solve - --profile profile/allegro_right.h5 --avoid > lines.json
code=$?
grep -o '"scaled":0.[0-9]\|"scaled":1.0\|"line":2' lines.json
exit $code
#? 1
#> "scaled":0.4
#> "line":2
#> "scaled":1.0
#2> uhas-solve: warning: scaled back 1 of 2 actions: the hand would collide with itself
#2> uhas-solve: error: standard input: 1 of the lines could not be solved; see "error" in the output
