uhas-classify-joints
#? 2
#2> uhas-classify-joints: error: hand.urdf is required; see uhas-classify-joints --help
