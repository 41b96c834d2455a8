uhas-build-profile --version
#> uhas-build-profile 0.1.0
#> hand profile format 1.0
#> JSON formats 1
