echo hello > hand.h5; uhas-inspect hand.h5
