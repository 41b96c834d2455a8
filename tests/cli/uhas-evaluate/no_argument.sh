uhas-evaluate
