echo '{"joint_limits": {"index_joint_2": [-3, 1.5]}}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
