uhas-project-surface hand/allegro_right.urdf --samples 0
#? 2
#2> uhas-project-surface: error: --samples: Value 0 not in range 1 to 1000000; see uhas-project-surface --help
