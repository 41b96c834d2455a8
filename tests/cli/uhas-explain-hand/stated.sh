# what a config states is surely so; the rest is inferred as before
cat > hand.json <<'EOF'
{"thumb": "thumb_joint_3", "handedness": "none", "q_open": {"index_joint_1": 0.1},
 "joint_limits": {"index_joint_2": [0, 1.5]}}
EOF
uhas-explain-hand hand/allegro_right.urdf --config hand.json
