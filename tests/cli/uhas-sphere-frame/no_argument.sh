uhas-sphere-frame
#? 2
#2> uhas-sphere-frame: error: hand.urdf is required; see uhas-sphere-frame --help
