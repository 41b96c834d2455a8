uhas-build-profile hand/allegro_right.urdf --geometry visuals
#? 2
#2> uhas-build-profile: error: --geometry: visuals not in {visual,collision,both}; see uhas-build-profile --help
