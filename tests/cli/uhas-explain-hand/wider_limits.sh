echo '{"joint_limits": {"index_joint_2": [-3, 1.5]}}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
#? 1
#2> uhas-explain-hand: error: hand.json: joint_limits: [-3, 1.5] is wider than the limits of "index_joint_2"; they can only be narrowed, within [-0.174, 1.709]
