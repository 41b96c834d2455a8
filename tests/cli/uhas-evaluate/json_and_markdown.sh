uhas-evaluate profile/allegro_right.h5 --json --markdown
