uhas-inspect --quiet profile/allegro_right.h5 --html missing/report.html
