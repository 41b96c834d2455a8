uhas-classify-joints hand/allegro_right.urdf --jsno
#? 2
#2> uhas-classify-joints: error: The following argument was not expected: --jsno; see uhas-classify-joints --help
