uhas-evaluate --help
