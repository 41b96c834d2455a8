uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 no_such.jsonl
