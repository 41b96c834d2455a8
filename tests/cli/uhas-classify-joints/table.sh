uhas-classify-joints hand/allegro_right.urdf
#> finger  joint           class         sideways, mm  curling, mm  margin  remark
#> ring    ring_joint_0    lateral               78.0         42.9    0.29  measured with the joints further out flexed
#>         ring_joint_1    encompassing           5.4         91.0    0.89
#>         ring_joint_2    encompassing           3.0         51.8    0.89
#>         ring_joint_3    encompassing           1.6         28.1    0.89
#> middle  middle_joint_0  lateral               84.3         27.7    0.50  measured with the joints further out flexed
#>         middle_joint_1  encompassing           0.6         91.2    0.99
#>         middle_joint_2  encompassing           0.3         52.0    0.99
#>         middle_joint_3  encompassing           0.2         28.1    0.99
#> index   index_joint_0   lateral               80.1         38.6    0.35  measured with the joints further out flexed
#>         index_joint_1   encompassing           4.4         91.1    0.91
#>         index_joint_2   encompassing           2.5         51.9    0.91
#>         index_joint_3   encompassing           1.3         28.1    0.91
#> thumb   thumb_joint_0   encompassing          15.2         80.1    0.68
#>         thumb_joint_1   lateral               27.9         20.8    0.14  measured with the joints further out flexed
#>         thumb_joint_2   encompassing          18.7         70.3    0.58
#>         thumb_joint_3   encompassing           8.8         34.8    0.60
