echo '{"palm_link": "palm"}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json --write-config hand.json
code=$?
cat hand.json
exit $code
#? 1
#> {"palm_link": "palm"}
#2> uhas-explain-hand: error: hand.json: would be written, but it is read too; write to another file
