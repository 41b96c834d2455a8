uhas-inspect --version
