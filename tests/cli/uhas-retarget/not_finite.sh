/usr/bin/python3 - <<'END'
import h5py
with h5py.File("t.h5", "w") as file:
    file["joint_names"] = [f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]
    file["q"] = [[0.4] * 16, [0.4] * 15 + [float("nan")]]
END
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 t.h5 -o out.h5
code=$?
ls -A | grep -v -x -e hand -e profile -e t.h5
exit $code
#? 1
#2> uhas-retarget: error: t.h5: frame 1: has a value that is not finite; mend or leave out the frame
