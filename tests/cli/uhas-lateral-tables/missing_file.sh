uhas-lateral-tables hand/missing.urdf
#? 1
#2> uhas-lateral-tables: error: hand/missing.urdf: the file does not exist; check the path
