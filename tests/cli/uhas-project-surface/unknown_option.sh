uhas-project-surface hand/allegro_right.urdf --jsno
#? 2
#2> uhas-project-surface: error: The following argument was not expected: --jsno; see uhas-project-surface --help
