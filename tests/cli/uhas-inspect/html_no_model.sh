uhas-inspect profile/allegro_right.h5 --html report.html && ls
