# the value of an item is what its key has in a written config
uhas-explain-hand hand/allegro_right.urdf --json --write-config hand.json > explanation.json
python3 - <<'EOF'
import json
config = json.load(open("hand.json"))
for item in json.load(open("explanation.json"))["items"]:
    print(item["item"], "same" if item["value"] == config.pop(item["item"]) else "different")
print(*config)
EOF
#> palm_link same
#> fingers same
#> fingertips same
#> thumb same
#> palm_normal_in_root same
#> q_open same
#> middle_finger same
#> handedness same
#> q_closed same
#> format version
