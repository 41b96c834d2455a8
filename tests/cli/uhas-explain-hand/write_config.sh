# all that was inferred, as a config that a second run takes and writes again, byte for byte
uhas-explain-hand hand/allegro_right.urdf --write-config hand.json > /dev/null
uhas-explain-hand hand/allegro_right.urdf --config hand.json --write-config again.json > /dev/null && cmp hand.json again.json
# the last digits of inferred numbers belong to the machine
python3 - <<'EOF'
import json
for key, value in json.load(open("hand.json"), parse_float=lambda text: round(float(text), 3) + 0.0).items():
    print(key, json.dumps(value))
EOF
