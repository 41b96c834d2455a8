uhas-inspect profile/allegro_right.h5 --findings | tail -n 10
#> item                 value                             confidence  reason
#> palm_link            palm                                    1.00  the lowest group of links in which all long chains of joints meet
#> fingers              4 fingers                               1.00  branches of movable joints from the palm, each as long as a finger
#> fingertips           one a finger                            0.95  frame index_tip stands at the end of the last phalanx
#> thumb                thumb_joint_0 .. thumb_joint_3          1.00  without it the others are most alike in direction, closing side and place of their knuckles
#> palm_normal_in_root  1.000 0.000 0.000                       0.89  mean direction in which the fingers close, the side of their larger joint ranges
#> q_open               fingers extended                        1.00  each finger straight in the palm plane with its pad toward the palm normal
#> middle_finger        middle_joint_0 .. middle_joint_3        1.00  second from the thumb across the palm
#> handedness           right                                   1.00  the side of the middle finger on which the open thumb stands
#> q_closed             fingers closed                          1.00  the end on whose side the fingertip comes nearest to the sphere's centre
