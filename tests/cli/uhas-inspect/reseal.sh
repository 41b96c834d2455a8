# stderr: the edited file is refused before it is resealed
# an edit with h5py breaks the seal, --reseal restores it
cp profile/allegro_right.h5 hand.h5
/usr/bin/python3 -c "
import h5py
with h5py.File('hand.h5', 'r+') as file: file['sphere/radius'][()] = 0.11
"
uhas-inspect hand.h5
uhas-inspect hand.h5 --reseal | grep Sphere
