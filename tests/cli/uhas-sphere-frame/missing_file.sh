uhas-sphere-frame hand/missing.urdf
