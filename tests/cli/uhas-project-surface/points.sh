# every kept hit is a point in the file
uhas-project-surface hand/allegro_right.urdf --json -o points.json > hits.json
/usr/bin/python3 - <<'END'
import json
hits, points = json.load(open("hits.json")), json.load(open("points.json"))
assert hits["points"] == len(points["points"]) == sum(link["kept"] for link in hits["links"]) > 1000
assert sum(point["weight"] > 0 for point in points["points"]) > 100
END
