uhas-explain-hand hand/allegro_right.urdf --jsno
#? 2
#2> uhas-explain-hand: error: The following argument was not expected: --jsno; see uhas-explain-hand --help
