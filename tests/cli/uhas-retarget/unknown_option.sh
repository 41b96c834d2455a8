uhas-retarget --from hand.h5 --to hand.h5 trajectory.json --jsno
#? 2
#2> uhas-retarget: error: The following argument was not expected: --jsno; see uhas-retarget --help
