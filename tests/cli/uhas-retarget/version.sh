uhas-retarget --version
#> uhas-retarget 0.1.0
#> hand profile format 1.0
#> JSON formats 1
