# all that was inferred, as a config that a second run takes and writes again, byte for byte
uhas-explain-hand hand/allegro_right.urdf --write-config hand.json > /dev/null
uhas-explain-hand hand/allegro_right.urdf --config hand.json --write-config again.json > /dev/null && cmp hand.json again.json
# the last digits of inferred numbers belong to the machine
python3 - <<'EOF'
import json
for key, value in json.load(open("hand.json"), parse_float=lambda text: round(float(text), 3) + 0.0).items():
    print(key, json.dumps(value))
EOF
#> format "uhas-hand-config"
#> version 1
#> fingers [["index_joint_0", "index_joint_1", "index_joint_2", "index_joint_3"], ["middle_joint_0", "middle_joint_1", "middle_joint_2", "middle_joint_3"], ["ring_joint_0", "ring_joint_1", "ring_joint_2", "ring_joint_3"], ["thumb_joint_0", "thumb_joint_1", "thumb_joint_2", "thumb_joint_3"]]
#> fingertips [{"link": "index_tip", "pad_normal": [1.0, 0.0, 0.0], "point": [0.0, 0.0, 0.0]}, {"link": "middle_tip", "pad_normal": [1.0, 0.0, 0.0], "point": [0.0, 0.0, 0.0]}, {"link": "ring_tip", "pad_normal": [1.0, 0.0, 0.0], "point": [0.0, 0.0, 0.0]}, {"link": "thumb_tip", "pad_normal": [1.0, 0.0, 0.0], "point": [0.0, 0.0, 0.0]}]
#> handedness "right"
#> middle_finger "middle_joint_3"
#> palm_link "palm"
#> palm_normal_in_root [1.0, 0.0, 0.0]
#> q_closed {"index_joint_0": 0.47, "index_joint_1": 1.61, "index_joint_2": 1.709, "index_joint_3": 1.618, "middle_joint_0": 0.47, "middle_joint_1": 1.61, "middle_joint_2": 1.709, "middle_joint_3": 1.618, "ring_joint_0": 0.47, "ring_joint_1": 1.61, "ring_joint_2": 1.709, "ring_joint_3": 1.618, "thumb_joint_0": 1.396, "thumb_joint_1": -0.105, "thumb_joint_2": 1.644, "thumb_joint_3": 1.719}
#> q_open {"index_joint_0": 0.0, "index_joint_1": 0.0, "index_joint_2": 0.0, "index_joint_3": 0.0, "middle_joint_0": 0.0, "middle_joint_1": 0.0, "middle_joint_2": 0.0, "middle_joint_3": 0.0, "ring_joint_0": 0.0, "ring_joint_1": 0.0, "ring_joint_2": 0.0, "ring_joint_3": 0.0, "thumb_joint_0": 0.263, "thumb_joint_1": 1.163, "thumb_joint_2": 0.0, "thumb_joint_3": 0.0}
#> thumb "thumb_joint_3"
