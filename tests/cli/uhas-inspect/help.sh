uhas-inspect --help
#> Shows what a hand profile says: palm, sphere, fingers, joints and poses.
#> Usage: uhas-inspect [OPTIONS] profile.h5...
#>
#> Positionals:
#>   profile.h5 FILE... REQUIRED Hand profile; several with --html
#>
#> Options:
#>   -g,--get KEY                Print one value of the JSON summary instead, for example sphere.radius or fingers.0.name
#>   --findings                  Show also what was inferred of the hand, how surely and why
#>   --validate                  Check instead that the profile is sound; exit 1 when it is not
#>   --check hand.urdf           Check instead that the profile was built from this URDF and its meshes; exit 1 when not
#>   --html hand.html            Draw the hands, which move by sliders, as a page for any browser, offline
#>   --gltf hand.glb             Draw the wrapped hand, its sphere and its surface points as binary glTF
#>   --ply points.ply            Write the surface points with their sphere coordinates as PLY
#>   --svg tables.svg            Draw the lateral tables as SVG
#>   --urdf hand.urdf            URDF that the profile was built from, for its meshes; repeatable [the one beside the profile or in this folder]
#>   --package NAME=DIR          Folder that package://NAME/ stands for; repeatable
#>   --allow-outside             Read meshes outside the folder of the model and of its packages, too
#>   --reseal                    Make a profile that was edited with an HDF5 tool readable again
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
