uhas-solve --help
