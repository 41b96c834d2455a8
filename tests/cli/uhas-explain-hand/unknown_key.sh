echo '{"palm": "palm"}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
#? 1
#2> uhas-explain-hand: error: hand.json: unknown key "palm"; did you mean "palm_link"?
