uhas-classify-joints --help
