uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 trajectory.csv
#? 2
#2> uhas-retarget: error: trajectory.csv: the name of a trajectory ends in .json, .jsonl, .h5 or .hdf5; see uhas-retarget --help
