uhas-inspect --version
#> uhas-inspect 0.1.0
#> hand profile format 1.0
#> JSON formats 1
