# stderr: every tool refuses
for tool in $(cd "$(dirname "$(command -v uhas-solve)")" && echo uhas-*); do
  $tool
  echo "$tool exits with $?"
done
#> uhas-build-profile exits with 2
#> uhas-classify-joints exits with 2
#> uhas-evaluate exits with 2
#> uhas-explain-hand exits with 2
#> uhas-inspect exits with 2
#> uhas-lateral-tables exits with 2
#> uhas-project-surface exits with 2
#> uhas-retarget exits with 2
#> uhas-solve exits with 2
#> uhas-sphere-frame exits with 2
#2> uhas-build-profile: error: hand.urdf is required; see uhas-build-profile --help
#2> uhas-classify-joints: error: hand.urdf is required; see uhas-classify-joints --help
#2> uhas-evaluate: error: profile.h5 is required; see uhas-evaluate --help
#2> uhas-explain-hand: error: hand.urdf is required; see uhas-explain-hand --help
#2> uhas-inspect: error: profile.h5 is required; see uhas-inspect --help
#2> uhas-lateral-tables: error: hand.urdf is required; see uhas-lateral-tables --help
#2> uhas-project-surface: error: hand.urdf is required; see uhas-project-surface --help
#2> uhas-retarget: error: trajectory is required; see uhas-retarget --help
#2> uhas-solve: error: actions.json is required; see uhas-solve --help
#2> uhas-sphere-frame: error: hand.urdf is required; see uhas-sphere-frame --help
