echo '[0.4, 0.4]' > t.jsonl
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.jsonl
#? 1
#2> uhas-retarget: error: t.jsonl: does not open with the order of the joints; write a first line {"format": "uhas-trajectory", "version": 1, "joint_names": [...]}
