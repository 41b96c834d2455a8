uhas-classify-joints --version
