uhas-retarget
#? 2
#2> uhas-retarget: error: trajectory is required; see uhas-retarget --help
