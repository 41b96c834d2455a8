uhas-project-surface
#? 2
#2> uhas-project-surface: error: hand.urdf is required; see uhas-project-surface --help
