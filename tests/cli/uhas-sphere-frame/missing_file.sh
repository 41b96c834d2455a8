uhas-sphere-frame hand/missing.urdf
#? 1
#2> uhas-sphere-frame: error: hand/missing.urdf: the file does not exist; check the path
