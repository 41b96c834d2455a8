# the profile is named after the robot and appears in the current folder
uhas-build-profile --quiet hand/allegro_right.urdf && ls
#> allegro_right.h5
#> hand
#> profile
