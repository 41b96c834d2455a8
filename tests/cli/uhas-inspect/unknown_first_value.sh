uhas-inspect profile/allegro_right.h5 -g radius
#? 1
#2> uhas-inspect: error: there is no value radius; there are format, version, hand, handedness, mirrored, palm_link, confidence, palm_normal_in_root, sphere, joint_names, q_open, q_sphere, q_closed, other_joints, fingers, warnings
