uhas-project-surface --help
#> Casts rays from the sphere's centre and shows which points of the wrapped hand they meet.
#> Usage: uhas-project-surface [OPTIONS] hand.urdf
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
#>   --lateral-steps N           Samples in the sweep of a lateral joint [201]
#>   --samples N                 Rays cast from the sphere's centre [20000]
#>   --points-per-link N         Points of a link that the solver uses, at most [32]
#>   -o,--output FILE            Also write every point to this file, as JSON
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
