# nor does the number of processors
processor=$(taskset -cp $$ | sed 's/.*: *//; s/[-,].*//')
taskset -c "$processor" uhas-build-profile --quiet hand/allegro_right.urdf && cmp allegro_right.h5 profile/allegro_right.h5
