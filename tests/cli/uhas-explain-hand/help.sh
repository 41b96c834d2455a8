uhas-explain-hand --help
#> Tells what is inferred of a robot hand from its URDF, how surely, and why.
#> Usage: uhas-explain-hand [OPTIONS] hand.urdf
#>
#> Positionals:
#>   hand.urdf FILE REQUIRED     URDF of the hand
#>
#> Options:
#>   --config FILE               Hand config (JSON) that overrides what would be inferred
#>   --package NAME=DIR          Folder that package://NAME/ stands for; repeatable
#>   --allow-outside             Read meshes outside the folder of the model and of its packages, too
#>   --geometry visual|collision|both
#>                               Which meshes are the hand's surface [visual]
#>   --radius-scale S            Factor on the sphere's radius [1]
#>   --merge-pinky               Five fingers: pinky and ring share the mean of their two slots
#>   --write-config FILE         Also write what was found as a hand config, to be corrected and given to --config
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
