uhas-sphere-frame --help
