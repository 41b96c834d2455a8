uhas-inspect profile/allegro_right.h5 -g fingers.3.name
uhas-inspect profile/allegro_right.h5 --get q_closed.index_joint_1
uhas-inspect profile/allegro_right.h5 -g fingers.0.slots
#> thumb
#> 1.61
#> [0,1]
