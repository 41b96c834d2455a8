uhas-explain-hand --version
#> uhas-explain-hand 0.1.0
#> hand profile format 1.0
#> JSON formats 1
