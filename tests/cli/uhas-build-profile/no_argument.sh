uhas-build-profile
