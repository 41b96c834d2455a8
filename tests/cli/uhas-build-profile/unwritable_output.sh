uhas-build-profile hand/allegro_right.urdf -o no/such/folder/hand.h5
#? 1
#2> uhas-build-profile: error: no/such/folder/hand.h5: no file can be made in its folder: No such file or directory; check the folder, its permissions and the free space
