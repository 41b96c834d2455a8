uhas-lateral-tables hand/allegro_right.urdf --jsno
#? 2
#2> uhas-lateral-tables: error: The following argument was not expected: --jsno; see uhas-lateral-tables --help
