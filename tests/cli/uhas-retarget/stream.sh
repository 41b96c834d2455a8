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
