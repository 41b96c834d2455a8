uhas-inspect --quiet profile/allegro_right.h5 --html missing/report.html
#? 1
#2> uhas-inspect: error: missing/report.html: no file can be made in its folder: No such file or directory; check the folder, its permissions and the free space
