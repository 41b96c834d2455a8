echo hello > hand.urdf; uhas-build-profile hand.urdf
