uhas-solve
#? 2
#2> uhas-solve: error: actions.json is required; see uhas-solve --help
