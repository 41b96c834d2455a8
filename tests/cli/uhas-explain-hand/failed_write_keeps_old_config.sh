echo old > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json --write-config hand.json
code=$?
cat hand.json
exit $code
