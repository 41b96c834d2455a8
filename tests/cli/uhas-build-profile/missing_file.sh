uhas-build-profile hand/missing.urdf; code=$?; ls; exit $code
#? 1
#> hand
#> profile
#2> uhas-build-profile: error: hand/missing.urdf: the file does not exist; check the path
