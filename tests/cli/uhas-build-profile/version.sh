uhas-build-profile --version
