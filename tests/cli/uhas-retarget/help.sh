uhas-retarget --help
#> Carries a trajectory of joint values from one hand to another.
#> Usage: uhas-retarget [OPTIONS] trajectory
#>
#> Positionals:
#>   trajectory FILE REQUIRED    Trajectory: .json, .jsonl or .h5; - reads one frame a line (JSON Lines) from standard input
#>
#> Options:
#>   --from FILE REQUIRED        Profile of the hand that was recorded
#>   --to FILE REQUIRED          Profile of the hand that is to move so
#>   -o,--output FILE            File to write to: .json, .jsonl or .h5 [standard output]
#>   --driving-vectors N         Driving vectors in each plane; more follow the first hand more closely [2]
#>
#>
#> Common options:
#>   --limit NAME=N              Refuse what is larger, for example mesh-bytes=1G; repeatable, uhas(7) has the names
#>   --force                     Replace files of another kind, and read-only ones, too
#>   --json                      Print the result as JSON
#>   -q,--quiet                  Print no warnings and no progress
#>   -v,--verbose                Say on stderr what is being done
#>   -V,--version                Print the version and exit; with --verbose those of the libraries, too
#>   -h,--help                   Print this help and exit
#>
#> Exit codes: 0 done, 1 the input or the run failed, 2 wrong usage.
