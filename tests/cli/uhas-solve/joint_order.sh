echo '{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [{"lateral": [0,0,0,0,0], "radial": [[-2,-2],[-2,-2],[-2,-2],[-2,-2],[-2,-2]]}]}' > actions.json
uhas-solve actions.json --joint-order index_joint_3,index_joint_1 | tr -d ' \n'; echo
#> {"format":"uhas-solution","version":1,"hand":"allegro_right","joint_names":["index_joint_3","index_joint_1"],"solutions":[{"q":[1.618,1.61],"residual_rms":null,"at_limit":[],"closed":["index_joint_3","index_joint_1"]}]}
