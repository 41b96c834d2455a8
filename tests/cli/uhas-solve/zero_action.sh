# the answer to a zero action is the wrapped pose
echo '{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [[0,0,0,0,0, 0,0, 0,0, 0,0, 0,0, 0,0]]}' > actions.json
uhas-solve actions.json -o solution.json
uhas-inspect profile/allegro_right.h5 --json > summary.json
/usr/bin/python3 - <<'END'
import json
solution, summary = json.load(open("solution.json")), json.load(open("summary.json"))
q = dict(zip(solution["joint_names"], solution["solutions"][0]["q"]))
assert solution["joint_names"] == summary["joint_names"]
assert all(abs(q[name] - value) < 1e-9 for name, value in summary["q_sphere"].items())
END
