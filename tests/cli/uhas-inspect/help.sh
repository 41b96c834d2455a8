uhas-inspect --help
