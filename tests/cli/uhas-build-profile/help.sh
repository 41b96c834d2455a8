uhas-build-profile --help
