uhas-build-profile hand/allegro_right.urdf --package NAME
#? 2
#2> uhas-build-profile: error: --package: NAME is not NAME=DIR; see uhas-build-profile --help
