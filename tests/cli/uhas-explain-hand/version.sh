uhas-explain-hand --version
