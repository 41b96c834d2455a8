# one line for each: not HDF5, no names, columns that are not those of the names
echo text > t.h5
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.h5
/usr/bin/python3 -c 'import h5py; h5py.File("t.h5", "w")["q"] = [[0.4] * 16]'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.h5
/usr/bin/python3 -c '
import h5py
file = h5py.File("t.h5", "w")
file["q"], file["joint_names"] = [[0.4] * 16], ["index_joint_0"]'
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.h5
