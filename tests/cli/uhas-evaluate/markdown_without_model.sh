uhas-evaluate profile/allegro_right.h5 --actions 10 --lines 0 --markdown | grep -e score -e collision
