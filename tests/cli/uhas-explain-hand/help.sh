uhas-explain-hand --help
