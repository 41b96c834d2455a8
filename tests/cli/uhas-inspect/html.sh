uhas-inspect profile/allegro_right.h5 --html report.html --urdf hand/allegro_right.urdf &&
head -n 1 report.html && ls
#> Wrote report.html
#> <!DOCTYPE html>
#> hand
#> profile
#> report.html
