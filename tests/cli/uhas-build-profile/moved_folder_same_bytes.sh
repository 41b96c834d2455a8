# nothing of the machine gets into the profile: spaces and UTF-8 in the path, another current folder
mkdir "meine Hände" && cp -rL hand "meine Hände/hand"
(cd "meine Hände" && uhas-build-profile --quiet hand/allegro_right.urdf -o "die Hand.h5")
cmp "meine Hände/die Hand.h5" profile/allegro_right.h5
