# a five-finger hand: at most 40 lines of 100 columns
uhas-build-profile --quiet hand/../human_right/human_right.urdf -o human.h5 2> /dev/null
uhas-inspect --quiet human.h5 > screen
awk 'length > 100' screen
test "$(wc -l < screen)" -le 40
