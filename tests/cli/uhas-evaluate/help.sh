uhas-evaluate --help
#> Scores a hand profile: reach, fit, surface, smoothness, self-collision and time of a solve.
#> Usage: uhas-evaluate [OPTIONS] profile.h5...
#>
#> Positionals:
#>   profile.h5 FILE... REQUIRED Hand profile; several are shown side by side
#>
#> Options:
#>   --actions N                 Random actions that the hand is judged by [400]
#>   --seed N                    Of the random actions and lines [1]
#>   --lines N                   Random lines along which joint steps are looked for [400]
#>   --threads N                 Threads to work on [all processors]; the scores do not depend on it
#>   --html hand.html            Also draw the hands with their scores as a page for any browser, offline
#>   --markdown                  Print the scores of all hands as a Markdown table
#>   --urdf hand.urdf            URDF that the profile was built from, for its meshes; repeatable [the one beside the profile or in this folder]
#>   --package NAME=DIR          Folder that package://NAME/ stands for; repeatable
#>   --allow-outside             Read meshes outside the folder of the model and of its packages, too
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
