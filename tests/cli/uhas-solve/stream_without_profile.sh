uhas-solve -
#? 2
#2> uhas-solve: error: --profile: needed when actions come from standard input; see uhas-solve --help
