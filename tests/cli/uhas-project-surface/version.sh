uhas-project-surface --version
#> uhas-project-surface 0.1.0
#> hand profile format 1.0
#> JSON formats 1
