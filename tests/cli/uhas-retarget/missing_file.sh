uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 no_such.jsonl
#? 1
#2> uhas-retarget: error: no_such.jsonl: the file does not exist; check the path
