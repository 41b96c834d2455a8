uhas-inspect profile/allegro_right.h5 | head -n 5
#> Hand    allegro_right, a right hand
#> Palm    link palm, normal (1.000, 0.000, 0.000) in palm
#> Sphere  radius 108.5 mm, centre (104.0, 4.8, -12.1) mm in palm
#> Points  3136 on the surface, palm included; the solver uses 640
#>
