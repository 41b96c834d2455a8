uhas-build-profile hand/allegro_right.urdf --quiet --verbose
#? 2
#2> uhas-build-profile: error: --verbose: excludes --quiet; see uhas-build-profile --help
