# what a config states is surely so; the rest is inferred as before
cat > hand.json <<'EOF'
{"thumb": "thumb_joint_3", "handedness": "none", "q_open": {"index_joint_1": 0.1},
 "joint_limits": {"index_joint_2": [0, 1.5]}}
EOF
uhas-explain-hand hand/allegro_right.urdf --config hand.json
#> item                 value                             confidence  reason
#> joint_limits         1 joint narrowed                        1.00  stated in the hand config
#> palm_link            palm                                    1.00  the lowest group of links in which all long chains of joints meet
#> fingers              4 fingers                               1.00  branches of movable joints from the palm, each as long as a finger
#> fingertips           one a finger                            0.95  frame index_tip stands at the end of the last phalanx
#> thumb                thumb_joint_0 .. thumb_joint_3          1.00  stated in the hand config
#> palm_normal_in_root  0.999 -0.003 -0.033                     0.91  mean direction in which the fingers close, the side of their larger joint ranges
#> q_open               fingers extended                        1.00  each finger straight in the palm plane with its pad toward the palm normal; 1 joint stated in the hand config
#> middle_finger        middle_joint_0 .. middle_joint_3        1.00  second from the thumb across the palm
#> handedness           none                                    1.00  stated in the hand config
#> q_closed             fingers closed                          1.00  the end on whose side the fingertip comes nearest to the sphere's centre
#>
#> finger  joints                                                       tip link      point, mm  remark
#> ring    ring_joint_0 ring_joint_1 ring_joint_2 ring_joint_3          ring_tip    0.0 0.0 0.0
#> middle  middle_joint_0 middle_joint_1 middle_joint_2 middle_joint_3  middle_tip  0.0 0.0 0.0  middle finger
#> index   index_joint_0 index_joint_1 index_joint_2 index_joint_3      index_tip   0.0 0.0 0.0
#> thumb   thumb_joint_0 thumb_joint_1 thumb_joint_2 thumb_joint_3      thumb_tip   0.0 0.0 0.0  thumb
