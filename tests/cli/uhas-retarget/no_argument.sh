uhas-retarget
