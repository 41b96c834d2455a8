uhas-lateral-tables --version
#> uhas-lateral-tables 0.1.0
#> hand profile format 1.0
#> JSON formats 1
