uhas-lateral-tables
#? 2
#2> uhas-lateral-tables: error: hand.urdf is required; see uhas-lateral-tables --help
