uhas-sphere-frame --version
