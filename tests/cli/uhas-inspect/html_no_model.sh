uhas-inspect profile/allegro_right.h5 --html report.html && ls
#> Wrote report.html
#> hand
#> profile
#> report.html
#2> uhas-inspect: warning: profile/allegro_right.h5: its model is not here, so the picture lacks the meshes; name the URDF with --urdf
