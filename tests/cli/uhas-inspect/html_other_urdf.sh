sed s/0.2/0.3/ hand/allegro_right.urdf > other.urdf
uhas-inspect profile/allegro_right.h5 --html report.html --urdf other.urdf
code=$?
ls
exit $code
#? 1
#> hand
#> other.urdf
#> profile
#2> uhas-inspect: error: other.urdf: is not what profile/allegro_right.h5 was built from; name the same URDF, or see uhas-inspect --check for what has changed
