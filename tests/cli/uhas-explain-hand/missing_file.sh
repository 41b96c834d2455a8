uhas-explain-hand hand/missing.urdf
#? 1
#2> uhas-explain-hand: error: hand/missing.urdf: the file does not exist; check the path
