echo '{"thumb": "thumb_joint_7"}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
#? 1
#2> uhas-explain-hand: error: hand.json: thumb: no finger has a joint "thumb_joint_7"; did you mean "thumb_joint_0"?
