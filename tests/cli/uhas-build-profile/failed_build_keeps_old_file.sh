cp profile/allegro_right.h5 hand.h5
echo '{"palm": "palm"}' > config.json
uhas-build-profile hand/allegro_right.urdf --config config.json -o hand.h5
code=$?
cmp hand.h5 profile/allegro_right.h5 && ls
exit $code
