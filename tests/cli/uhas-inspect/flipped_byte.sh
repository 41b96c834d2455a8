cp profile/allegro_right.h5 hand.h5
printf '\377\000\377' | dd of=hand.h5 bs=1 seek=20000 conv=notrunc status=none
uhas-inspect hand.h5 --validate
