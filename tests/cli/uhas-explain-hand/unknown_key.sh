echo '{"palm": "palm"}' > hand.json
uhas-explain-hand hand/allegro_right.urdf --config hand.json
