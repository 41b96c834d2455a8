uhas-explain-hand hand/allegro_right.urdf --jsno
