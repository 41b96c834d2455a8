uhas-sphere-frame hand/allegro_right.urdf --jsno
#? 2
#2> uhas-sphere-frame: error: The following argument was not expected: --jsno; see uhas-sphere-frame --help
