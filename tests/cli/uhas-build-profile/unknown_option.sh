uhas-build-profile hand/allegro_right.urdf --jsno
#? 2
#2> uhas-build-profile: error: The following argument was not expected: --jsno; see uhas-build-profile --help
