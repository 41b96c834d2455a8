echo hello > hand.h5; uhas-inspect hand.h5
#? 1
#2> uhas-inspect: error: hand.h5: this is not a hand profile: it does not begin with 'uhas-hand-profile'; name a file that uhas-build-profile wrote
