uhas-solve --help
#> Turns actions, deformations of the sphere, into joint angles of a hand.
#> Usage: uhas-solve [OPTIONS] actions.json
#>
#> Positionals:
#>   actions.json FILE REQUIRED  Actions; - reads one action a line (JSON Lines) from standard input
#>
#> Options:
#>   --profile FILE              Hand profile [the one that the actions file names]
#>   -o,--output FILE            File to write the solution to [standard output]
#>   --convention uhas|uhas-sim  What the numbers of an action mean [the one that the actions file names, else uhas]
#>   --rule correspondence|contact
#>                               How a joint angle follows from the deformed sphere [correspondence]
#>   --closing fade|hard         How joints close as the sphere vanishes [fade]
#>   --field finger|field        Which deformation a point takes: its finger's, or the interpolated one [finger]
#>   --passes N                  Sweeps over each finger; more come nearer to the optimum [1]
#>   --joint-order A,B,C         Joints to print, in this order [those of the profile]
#>   --actuated-only             Leave out joints that follow another one
#>   --collisions                State with each solution which links come nearest to each other, and how near
#>   --avoid                     Scale back actions whose solution has the hand collide with itself
#>   --html hand.html            Draw also the solutions, played on the hand, as a page for any browser, offline
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
