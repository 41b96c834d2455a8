uhas-build-profile hand/missing.urdf; code=$?; ls; exit $code
