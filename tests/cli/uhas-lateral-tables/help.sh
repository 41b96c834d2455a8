uhas-lateral-tables --help
