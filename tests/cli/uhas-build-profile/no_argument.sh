uhas-build-profile
#? 2
#2> uhas-build-profile: error: hand.urdf is required; see uhas-build-profile --help
