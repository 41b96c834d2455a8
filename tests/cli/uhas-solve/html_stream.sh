uhas-solve - --profile profile/allegro_right.h5 --html report.html
