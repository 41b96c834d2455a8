echo '[0.4, 0.4]' > t.jsonl
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.jsonl
