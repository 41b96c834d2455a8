uhas-solve actions.json --jsno
#? 2
#2> uhas-solve: error: The following argument was not expected: --jsno; see uhas-solve --help
