# two profiles of one hand, one of a smaller sphere
uhas-build-profile hand/allegro_right.urdf -o small.h5 --radius-scale 0.8 --quiet > log
uhas-evaluate profile/allegro_right.h5 small.h5 --urdf hand/allegro_right.urdf --urdf hand/allegro_right.urdf --actions 20 --lines 5 | grep -v '^time'
#> score                                            allegro_right (profile/allegro_right.h5)  allegro_right (small.h5)  difference
#> reach, delta theta followed, %                                                        100                        99          -1
#> reach, delta r followed, %                                                             40                        46           6
#> reach, dead inputs                                                                      0                         0           0
#> reach, joint most at a limit, % of actions                                             15                        20           5
#> fit, optimum, median, radii                                                         0.113                     0.152       0.039
#> fit, 1 pass / optimum, median                                                       1.011                     1.014       0.003
#> fit, 1 pass / optimum, p95                                                          1.082                     1.094       0.012
#> fit, 3 passes / optimum, median                                                     1.005                     1.005       0.000
#> fit, 3 passes / optimum, p95                                                        1.031                     1.044       0.012
#> fit, 10 passes / optimum, median                                                    1.001                     1.000       0.000
#> fit, 10 passes / optimum, p95                                                       1.010                     1.006      -0.004
#> fit, contact / optimum, median                                                      1.222                     1.335       0.113
#> surface, off the sphere at rest, median, radii                                      0.083                     0.110       0.027
#> surface, off the deformed sphere, median, radii                                     0.103                     0.138       0.034
#> surface, off the deformed sphere, p95, radii                                        0.269                     0.360       0.091
#> surface, coverage, %                                                                   48                        57           9
#> surface, largest hole, deg                                                             53                        45          -8
#> smoothness, delta r, rad a radius                                                     5.6                       5.7         0.1
#> smoothness, delta r, 3 passes, rad a radius                                           5.6                       6.1         0.5
#> smoothness, delta theta, rad a rad                                                    4.3                       2.4        -1.9
#> collision, % of actions                                                              10.0                      10.0         0.0
#> collision, distance, median, mm                                                      18.9                      18.6        -0.3
