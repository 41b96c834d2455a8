uhas-explain-hand
#? 2
#2> uhas-explain-hand: error: hand.urdf is required; see uhas-explain-hand --help
