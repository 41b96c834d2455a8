echo '{"format": "uhas-actions", "version": 1, "profile": "profile/allegro_right.h5", "actions": [{"lateral": [0,0,0,0,0], "radial": [[-2,-2],[-2,-2],[-2,-2],[-2,-2],[-2,-2]]}]}' > actions.json
uhas-solve actions.json --joint-order index_joint_3,elbow
#? 2
#2> uhas-solve: error: --joint-order: no joint is called elbow, the joints are index_joint_0,index_joint_1,index_joint_2,index_joint_3,middle_joint_0,middle_joint_1,middle_joint_2,middle_joint_3,ring_joint_0,ring_joint_1,ring_joint_2,ring_joint_3,thumb_joint_0,thumb_joint_1,thumb_joint_2,thumb_joint_3; see uhas-solve --help
