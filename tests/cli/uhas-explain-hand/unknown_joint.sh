echo '{"thumb": "thumb_joint_7"}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
