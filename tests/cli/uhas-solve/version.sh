uhas-solve --version
