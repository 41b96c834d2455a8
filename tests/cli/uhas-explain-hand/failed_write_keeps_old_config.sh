echo old > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json --write-config hand.json
code=$?
cat hand.json
exit $code
#? 1
#> old
#2> uhas-explain-hand: error: hand.json:1: not JSON: syntax error while parsing value - invalid literal; last read: 'o'; correct the syntax
