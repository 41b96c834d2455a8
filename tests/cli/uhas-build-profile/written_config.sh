# building with what was inferred gives the same numbers, but for how surely they are known
uhas-build-profile hand/allegro_right.urdf -o a.h5 --json --write-config hand.json > inferred.json
uhas-build-profile hand/allegro_right.urdf -o b.h5 --json --config hand.json > stated.json
python3 - <<'EOF'
import json
inferred, stated = (json.load(open(name)) for name in ("inferred.json", "stated.json"))
print([key for key in inferred if inferred[key] != stated[key]], set(stated["confidence"].values()))
EOF
#> ['confidence'] {1.0}
