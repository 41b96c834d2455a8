uhas-explain-hand hand/missing.urdf
