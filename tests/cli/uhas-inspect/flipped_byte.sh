cp profile/allegro_right.h5 hand.h5
printf '\377\000\377' | dd of=hand.h5 bs=1 seek=20000 conv=notrunc status=none
uhas-inspect hand.h5 --validate
#? 1
#2> uhas-inspect: error: hand.h5: the file is damaged: its content does not have the SHA-256 and length that it states; rebuild it with uhas-build-profile, or reseal it with uhas-inspect if you edited it
