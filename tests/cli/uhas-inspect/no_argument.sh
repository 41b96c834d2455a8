uhas-inspect
