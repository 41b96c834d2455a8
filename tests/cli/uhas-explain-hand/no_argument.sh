uhas-explain-hand
