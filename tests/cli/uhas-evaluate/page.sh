uhas-evaluate profile/allegro_right.h5 --urdf hand/allegro_right.urdf --actions 10 --lines 0 --html page.html > table
grep -c '"uhas-evaluation"' page.html
#> 1
