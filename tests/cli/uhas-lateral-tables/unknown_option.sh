uhas-lateral-tables hand/allegro_right.urdf --jsno
