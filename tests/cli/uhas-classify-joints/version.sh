uhas-classify-joints --version
#> uhas-classify-joints 0.1.0
#> hand profile format 1.0
#> JSON formats 1
