# stderr: every tool refuses
for tool in $(cd "$(dirname "$(command -v uhas-solve)")" && echo uhas-*); do
  required=
  test $tool != uhas-retarget || required='--from hand.h5 --to hand.h5'
  $tool input $required --jsno
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
#2> uhas-build-profile: error: The following argument was not expected: --jsno; see uhas-build-profile --help
#2> uhas-classify-joints: error: The following argument was not expected: --jsno; see uhas-classify-joints --help
#2> uhas-evaluate: error: The following argument was not expected: --jsno; see uhas-evaluate --help
#2> uhas-explain-hand: error: The following argument was not expected: --jsno; see uhas-explain-hand --help
#2> uhas-inspect: error: The following argument was not expected: --jsno; see uhas-inspect --help
#2> uhas-lateral-tables: error: The following argument was not expected: --jsno; see uhas-lateral-tables --help
#2> uhas-project-surface: error: The following argument was not expected: --jsno; see uhas-project-surface --help
#2> uhas-retarget: error: The following argument was not expected: --jsno; see uhas-retarget --help
#2> uhas-solve: error: The following argument was not expected: --jsno; see uhas-solve --help
#2> uhas-sphere-frame: error: The following argument was not expected: --jsno; see uhas-sphere-frame --help
