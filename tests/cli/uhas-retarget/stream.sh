# one line out for each line in; a header says the order of what follows, a bad line does not stop the stream
names=$(/usr/bin/python3 -c 'import json; print(json.dumps([f"{f}_joint_{i}" for f in ("thumb", "index", "middle", "ring") for i in range(4)]))')
printf '%s\n' '[0,0.5,0.5,0.5, 0,0.5,0.5,0.5, 0,0.5,0.5,0.5, 0.5,0.5,0.5,0.5]' "{\"format\":\"uhas-trajectory\",\"version\":1,\"joint_names\":$names}" \
  '{"q": [0.5,0.5,0.5,0.5, 0,0.5,0.5,0.5, 0,0.5,0.5,0.5, 0,0.5,0.5,0.5]}' '[1, 2]' '{"q": "none"}' '{"format":"uhas-trajectory","version":2}' '[1' > lines.jsonl
uhas-retarget - --from profile/allegro_right.h5 --to profile/allegro_right.h5 < lines.jsonl > out.jsonl
code=$?
sed 's/"q":\[[^]]*\],"residual_max":[^,]*,"residual_rms":[^}]*/retargeted/; s/"residual_rms".*"worst/..., "worst/; s/\("joint_names":\["[^"]*\).*/\1 .../' out.jsonl
/usr/bin/python3 -c 'import json
lines = [json.loads(line) for line in open("out.jsonl")]
print(lines[0] == lines[2])  # the same posture in two orders'
exit $code
#? 1
#> {retargeted}
#> {"format":"uhas-trajectory","version":1,"hand":"allegro_right","joint_names":["index_joint_0 ...
#> {retargeted}
#> {"error":"frame: has 2 values for 16 joints; write one for each joint of joint_names","line":4}
#> {"error":"frame: is not a frame; write an array of numbers, or {\"q\": [numbers]}","line":5}
#> {"error":"header: version is 2, this tool reads 1; write \"version\": 1","line":6}
#> {"error":"not JSON: syntax error while parsing array - unexpected end of input; expected ']'; correct the syntax","line":7}
#> {"summary":{"frames":2,"off_manifold":2,"tolerance":0.01,..., "worst_frame":0}}
#> True
#2> uhas-retarget: error: standard input: 4 of the lines could not be retargeted; see "error" in the output
