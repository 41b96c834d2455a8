# what a solve gave comes back; a posture that no action gives is told its distance
printf '%s\n' '[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]' '[0.1,0.1,-0.1,0.2,0, 0.2,0.1, 0.2,0.1, -0.2,-0.3, 0.1,0.3, -0.2,-0.1]' |
  uhas-solve - --profile profile/allegro_right.h5 > frames.jsonl
echo '[0,0.3,1.5,0, 0,1.5,0,1.5, 0,0,0,0, 1,0,0,0]' >> frames.jsonl
uhas-retarget - --from profile/allegro_right.h5 --to profile/allegro_right.h5 < frames.jsonl > back.jsonl
/usr/bin/python3 - <<'END'
import json
before = [json.loads(line) for line in open("frames.jsonl")]
*after, last = [json.loads(line) for line in open("back.jsonl")]
for row, frame in zip(before, after, strict=True):
    q = row["q"] if isinstance(row, dict) else row
    error = max(abs(a - b) for a, b in zip(q, frame["q"], strict=True))
    print("within" if error <= 0.01 else "beyond", "0.01 rad;", "told rightly" if abs(error - frame["residual_max"]) < 1e-9 else "told wrongly")
print({key: last["summary"][key] for key in ("frames", "off_manifold", "worst_frame")})
END
#> within 0.01 rad; told rightly
#> within 0.01 rad; told rightly
#> beyond 0.01 rad; told rightly
#> {'frames': 3, 'off_manifold': 1, 'worst_frame': 2}
