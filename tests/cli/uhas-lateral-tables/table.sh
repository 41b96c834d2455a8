uhas-lateral-tables hand/allegro_right.urdf
#> joint           drives  neutral, deg  azimuth there, deg  from, deg  to, deg  samples
#> index_joint_0   index            0.0               -25.3      -35.9     24.3      201
#> middle_joint_0  middle           0.0                 2.6      -24.8     25.9      201
#> ring_joint_0    ring             0.0                30.8      -25.1     42.7      201
#> thumb_joint_1   thumb           30.3              -113.2       -8.7     12.0      201
#> From and to are relative to the azimuth at neutral.
