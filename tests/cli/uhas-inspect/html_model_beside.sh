# the URDF beside the profile is known by its content; the page is the same as with --urdf, wherever it is written
cp -rL hand copy && cp profile/allegro_right.h5 copy
uhas-inspect copy/allegro_right.h5 --html found.html
uhas-inspect profile/allegro_right.h5 --html copy/named.html --urdf hand/allegro_right.urdf
cmp found.html copy/named.html
#> Wrote found.html
#> Wrote copy/named.html
