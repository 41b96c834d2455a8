# the page comes beside the solution, which stays as it is; its timeline holds the same joint values
set -e
cat > actions.json <<'END'
{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "normalized": true,
 "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0], [0.5,0,-0.5,1,-1, -1,-0.5, 0,0.5, 0,0, -1,0, 0,-1]]}
END
uhas-solve actions.json > alone.json
uhas-solve actions.json --html report.html --urdf hand/allegro_right.urdf > solution.json
cmp alone.json solution.json
python3 - <<'END'
import json, re
page = open("report.html").read()
data = json.loads(re.search('id="uhas-report">(.*?)</script>', page).group(1))
timeline = data["hands"][0]["timeline"]
solutions = json.load(open("solution.json"))["solutions"]
for key in ("residual_rms", "at_limit", "closed"):
    assert timeline[key] == [solution[key] for solution in solutions], key
difference = max(abs(a - b) for q, s in zip(timeline["q"], solutions, strict=True) for a, b in zip(q, s["q"], strict=True))
assert difference < 1e-12, difference
print([round(x, 3) for x in timeline["actions"][1]], timeline["options"])
END
#> [0.372, 0.0, -0.216, 0.425, -0.151, -2.0, -1.0, 0.0, 1.0, 0.0, 0.0, -2.0, 0.0, 0.0, -2.0] {'rule': 'correspondence', 'closing': 'fade', 'field': 'finger', 'passes': 1}
