uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 - -o out.jsonl
#? 2
#2> uhas-retarget: error: --output: a stream of frames goes to standard output; see uhas-retarget --help
