echo hello > hand.urdf; uhas-build-profile hand.urdf
#? 1
#2> uhas-build-profile: error: hand.urdf: this is not well-formed XML (Error document empty.); correct the file
