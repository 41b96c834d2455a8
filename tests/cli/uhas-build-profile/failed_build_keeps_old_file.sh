cp profile/allegro_right.h5 hand.h5
echo '{"palm": "palm"}' > config.json
uhas-build-profile hand/allegro_right.urdf --config config.json -o hand.h5
code=$?
cmp hand.h5 profile/allegro_right.h5 && ls
exit $code
#? 1
#> config.json
#> hand
#> hand.h5
#> profile
#2> uhas-build-profile: error: config.json: unknown key "palm"; did you mean "palm_link"?
