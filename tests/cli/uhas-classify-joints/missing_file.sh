uhas-classify-joints hand/missing.urdf
#? 1
#2> uhas-classify-joints: error: hand/missing.urdf: the file does not exist; check the path
