# the page plays what was left of the actions
echo '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0,0, 0,0,0,0,-2], [0,0,0,0,0, 0,0,0,0,0.1]]}' > actions.json
uhas-solve actions.json --profile profile/allegro_right.h5 --avoid --urdf hand/allegro_right.urdf --html page.html -o solution.json
/usr/bin/python3 - <<'END'
import json, re
page = json.loads(re.search(r'id="uhas-report">(.*?)</script>', open("page.html").read(), re.S)[1])
solutions = json.load(open("solution.json"))["solutions"]
timeline = page["hands"][0]["timeline"]
for action, asked, solution in zip(timeline["actions"], (-2, 0.1), solutions, strict=True):
    assert abs(action[9] - solution["scaled"] * asked) < 1e-12, (action, solution)
for q, solution in zip(timeline["q"], solutions, strict=True):
    assert max(abs(a - b) for a, b in zip(q, solution["q"], strict=True)) < 1e-12
END
#2> uhas-solve: warning: scaled back 1 of 2 actions: the hand would collide with itself
