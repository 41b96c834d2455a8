uhas-build-profile hand/allegro_right.urdf -o no/such/folder/hand.h5
