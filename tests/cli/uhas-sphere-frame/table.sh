uhas-sphere-frame hand/allegro_right.urdf
#> Hand    allegro_right, a right hand
#> Palm    link palm, centre (-4.5, 4.8, -12.1) mm
#> Sphere  radius 108.5 mm, centre (104.0, 4.8, -12.1) mm
#>         z = palm normal (1.000, 0.000, 0.000)
#>         x (0.000, 0.000, 1.000)
#> All in the frame of palm.
#>
#> finger  slots  tip link    palm centre to tip, mm  open azimuth, deg
#> ring    0,1    ring_tip                     169.0               21.2
#> middle  2      middle_tip                   160.4                1.7
#> index   3      index_tip                    165.8              -18.1
#> thumb   4      thumb_tip                    186.7             -113.9
