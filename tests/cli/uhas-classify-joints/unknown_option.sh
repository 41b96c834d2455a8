uhas-classify-joints hand/allegro_right.urdf --jsno
