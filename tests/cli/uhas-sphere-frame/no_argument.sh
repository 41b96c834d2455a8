uhas-sphere-frame
