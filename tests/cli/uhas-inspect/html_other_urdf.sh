sed s/0.2/0.3/ hand/allegro_right.urdf > other.urdf
uhas-inspect profile/allegro_right.h5 --html report.html --urdf other.urdf
code=$?
ls
exit $code
