uhas-solve actions.json --limit links=20K
#? 2
#2> uhas-solve: error: --limit: links=20K is not links=N, N a whole number from 1 to 10000; see uhas-solve --help
