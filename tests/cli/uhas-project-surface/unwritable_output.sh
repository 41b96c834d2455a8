uhas-project-surface hand/allegro_right.urdf -o no/such/folder/points.json
#? 1
#2> uhas-project-surface: error: no/such/folder/points.json: no file can be made in its folder: No such file or directory; check the folder, its permissions and the free space
