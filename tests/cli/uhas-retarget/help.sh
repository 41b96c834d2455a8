uhas-retarget --help
