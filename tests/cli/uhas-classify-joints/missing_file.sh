uhas-classify-joints hand/missing.urdf
