uhas-evaluate profile/allegro_right.h5 --urdf hand/allegro_right.urdf --actions 40 --lines 10 | grep -v '^time'
#> score                                            allegro_right
#> reach, delta theta followed, %                             100
#> reach, delta r followed, %                                  40
#> reach, dead inputs                                           0
#> reach, joint most at a limit, % of actions                  22
#> fit, optimum, median, radii                              0.106
#> fit, 1 pass / optimum, median                            1.011
#> fit, 1 pass / optimum, p95                               1.081
#> fit, 3 passes / optimum, median                          1.005
#> fit, 3 passes / optimum, p95                             1.024
#> fit, 10 passes / optimum, median                         1.001
#> fit, 10 passes / optimum, p95                            1.006
#> fit, contact / optimum, median                           1.236
#> surface, off the sphere at rest, median, radii           0.083
#> surface, off the deformed sphere, median, radii          0.110
#> surface, off the deformed sphere, p95, radii             0.284
#> surface, coverage, %                                        48
#> surface, largest hole, deg                                  53
#> smoothness, delta r, rad a radius                          5.6
#> smoothness, delta r, 3 passes, rad a radius                5.6
#> smoothness, delta theta, rad a rad                         4.3
#> collision, % of actions                                    7.5
#> collision, distance, median, mm                           18.9
#>
#> finger  delta theta, deg         useful       achieved  useful delta r, both, radii       achieved      at 60 deg     at 120 deg  dead
#> ring       -25.1 .. 42.7  -25.1 .. 42.7  -25.3 .. 47.8                -0.65 .. 0.95  -0.35 .. 0.43  -0.75 .. 1.05  -1.65 .. 2.00
#> middle     -24.8 .. 25.9  -24.8 .. 25.9  -25.1 .. 26.6                -0.65 .. 0.90  -0.55 .. 0.48  -0.70 .. 0.90  -2.00 .. 2.00
#> index      -35.9 .. 24.3  -35.9 .. 24.3  -39.9 .. 24.4                -0.65 .. 0.95  -0.41 .. 0.45  -0.75 .. 1.00  -1.80 .. 2.00
#> thumb       -8.7 .. 12.0   -8.7 .. 12.0   -10.3 .. 7.8                -0.60 .. 1.05  -0.41 .. 0.55  -0.75 .. 1.20  -1.60 .. 1.90
#>
#> finger  1 pass / optimum    p95  3 passes, p95  residual, radii    p95  off the deformed sphere, radii    p95  points at phi, deg  gap
#> ring               1.010  1.072          1.044            0.094  0.239                           0.091  0.238        19.9 .. 91.4  0.9
#> middle             1.013  1.068          1.024            0.089  0.246                           0.114  0.274         6.0 .. 85.1  0.7
#> index              1.011  1.030          1.013            0.138  0.292                           0.108  0.285        15.6 .. 89.1  0.7
#> thumb              1.007  1.089          1.012            0.146  0.288                           0.127  0.340        20.1 .. 95.4  0.6
#>
#> joint           rad a radius of delta r  3 passes  at a limit, % of actions
#> index_joint_1                       1.3       1.3                         0
#> index_joint_2                       5.1       5.2                         5
#> index_joint_3                       2.5       3.3                         0
#> middle_joint_1                      1.7       1.7                         0
#> middle_joint_2                      3.9       4.1                         0
#> middle_joint_3                      3.6       5.6                         0
#> ring_joint_1                        1.4       1.4                         0
#> ring_joint_2                        5.6       5.6                         8
#> ring_joint_3                        3.4       4.6                         2
#> thumb_joint_0                       0.9       0.9                         0
#> thumb_joint_2                       3.6       3.5                        22
#> thumb_joint_3                       4.0       4.4                         2
#>
#> links that touch                 poses
#> middle_link_3     ring_link_3        2
#> middle_tip        ring_link_3        2
#> middle_tip        ring_tip           2
#> index_link_3      middle_link_2      1
#> index_link_3      middle_link_3      1
