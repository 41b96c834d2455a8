# stderr: the edited file is refused before it is resealed
# an edit with h5py breaks the seal, --reseal restores it
cp profile/allegro_right.h5 hand.h5
/usr/bin/python3 -c "
import h5py
with h5py.File('hand.h5', 'r+') as file: file['sphere/radius'][()] = 0.11
"
uhas-inspect hand.h5
uhas-inspect hand.h5 --reseal | grep Sphere
#> Sphere  radius 110.0 mm, centre (104.0, 4.8, -12.1) mm in palm
#2> uhas-inspect: error: hand.h5: the file is damaged: its content does not have the SHA-256 and length that it states; rebuild it with uhas-build-profile, or reseal it with uhas-inspect if you edited it
