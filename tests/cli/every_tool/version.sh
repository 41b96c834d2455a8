for tool in $(cd "$(dirname "$(command -v uhas-solve)")" && echo uhas-*); do
  $tool --version || echo "exits with $?"
done
#> uhas-build-profile 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-classify-joints 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-evaluate 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-explain-hand 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-inspect 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-lateral-tables 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-project-surface 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-retarget 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-solve 0.1.0
#> hand profile format 1.0
#> JSON formats 1
#> uhas-sphere-frame 0.1.0
#> hand profile format 1.0
#> JSON formats 1
