uhas-retarget --from hand.h5 --to hand.h5 trajectory.json --jsno
