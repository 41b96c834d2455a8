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
#> Limits:
#>   --max-urdf-bytes N          Refuse a larger URDF [16777216]
#>   --max-links N               Refuse a model of more links [2000]
#>   --max-mesh-bytes N          Refuse a larger mesh file [536870912]
#>   --max-triangles N           Refuse a hand of more triangles [20000000]
#>   --max-json-bytes N          Refuse a larger file of actions [67108864]
#>   --max-actions N             Refuse a file of more actions; a stream may have any number [1000000]
#>   --max-read-seconds N        End the reading of a file that takes longer [60]
#>   --max-read-bytes N          End the reading of a file that takes more memory [4294967296]
#>
#>
#> Common options:
#>   --json                      Print the result as JSON
#>   --quiet                     Print no warnings and no progress
#>   --verbose                   Say on stderr what is being done
#>   --version                   Print the version and exit; with --verbose those of the libraries, too
#>   -h,--help                   Print this help and exit
#>
#> Exit codes: 0 done, 1 the input or the run failed, 2 wrong usage.
