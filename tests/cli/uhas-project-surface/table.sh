uhas-project-surface hand/allegro_right.urdf | head -n 2
#> link           points  too far  facing away
#> palm              984        0            0
