uhas-retarget --version
