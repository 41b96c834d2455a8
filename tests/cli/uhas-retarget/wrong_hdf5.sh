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
#? 1
#2> uhas-retarget: error: t.h5: cannot be opened as HDF5; check the path and what wrote the file
#2> uhas-retarget: error: t.h5: has no dataset joint_names, a list of names; store the names in the order of the columns of q
#2> uhas-retarget: error: t.h5: q has 16 columns for 1 joints; store one column for each name of joint_names
