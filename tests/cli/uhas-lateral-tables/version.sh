uhas-lateral-tables --version
