# one line out for each line in; a bad one does not stop the stream
printf '%s\n' '[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]' '[1, 2]' '' '{"lateral": [0,0,0,0,0]}' '[NaN]' '[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,1e999]' '{"lateral": [0,0,0,0,0], "radial": [[0],[0],[0],[0],["0"]]}' '{"lateral": [0,0,0,0,0], "radial": [[-2,-2],[-2,-2],[-2,-2],[-2,-2],[-2,-2]]}' > lines.json
uhas-solve - --profile profile/allegro_right.h5 < lines.json > solutions.json
code=$?
sed 's/"q":\[[^]]*\],"residual_rms":[^,]*/solved/' solutions.json
exit $code
#? 1
#> {solved,"at_limit":[],"closed":[]}
#> {"error":"action: has 2 numbers; write 5 + 5 V numbers for V = 1 to 4 driving vectors, 15 for the usual two","line":2}
#> {"error":"action: lateral or radial is missing; write {\"lateral\": [5 numbers], \"radial\": [5 arrays of V numbers]}","line":4}
#> {"error":"not JSON: syntax error while parsing value - invalid literal; last read: '[N'; correct the syntax","line":5}
#> {"error":"number overflow parsing '1e999'; write numbers within the range of double","line":6}
#> {"error":"action: element 0 of a plane of radial is \"0\"; write a number","line":7}
#> {solved,"at_limit":[],"closed":["index_joint_1","index_joint_2","index_joint_3","middle_joint_1","middle_joint_2","middle_joint_3","ring_joint_1","ring_joint_2","ring_joint_3","thumb_joint_0","thumb_joint_2","thumb_joint_3"]}
#2> uhas-solve: error: standard input: 5 of the lines could not be solved; see "error" in the output
