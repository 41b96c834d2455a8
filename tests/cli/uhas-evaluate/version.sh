uhas-evaluate --version
