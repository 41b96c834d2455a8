uhas-solve -
