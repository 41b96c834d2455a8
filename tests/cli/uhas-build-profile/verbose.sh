# stderr: --verbose says what is done
uhas-build-profile hand/allegro_right.urdf --verbose -o hand.h5 > /dev/null
#2> uhas-build-profile: reading the URDF and its meshes
#2> uhas-build-profile: finding palm and fingers
#2> uhas-build-profile: placing the sphere
#2> uhas-build-profile: classifying joints
#2> uhas-build-profile: wrapping the hand and sweeping lateral joints
#2> uhas-build-profile: casting rays on the hand's surface
