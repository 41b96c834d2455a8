uhas-lateral-tables hand/missing.urdf
