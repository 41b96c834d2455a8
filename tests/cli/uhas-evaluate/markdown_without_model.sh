uhas-evaluate profile/allegro_right.h5 --actions 10 --lines 0 --markdown | grep -e score -e collision
#> | score | allegro_right |
#> | collision, % of actions | - |
#> | collision, distance, median, mm | - |
#2> uhas-evaluate: warning: profile/allegro_right.h5: its model is not here, so self-collision is not scored; name the URDF with --urdf
