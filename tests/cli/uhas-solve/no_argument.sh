uhas-solve
