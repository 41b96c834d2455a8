uhas-lateral-tables
