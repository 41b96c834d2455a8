echo '{"format": "uhas-actions", "version": 1, "profile": "allegro_right.h5", "actions": []}' > profile/actions.json
uhas-solve profile/actions.json
#> {
#>   "format": "uhas-solution",
#>   "version": 1,
#>   "hand": "allegro_right",
#>   "joint_names": ["index_joint_0", "index_joint_1", "index_joint_2", "index_joint_3", "middle_joint_0", "middle_joint_1", "middle_joint_2", "middle_joint_3", "ring_joint_0", "ring_joint_1", "ring_joint_2", "ring_joint_3", "thumb_joint_0", "thumb_joint_1", "thumb_joint_2", "thumb_joint_3"],
#>   "solutions": []
#> }
