# colours on a terminal, none with NO_COLOR, on a dumb terminal or in a pipe
show() { script -qec "$1 uhas-inspect profile/allegro_right.h5" /dev/null < /dev/null | head -n 1 | cat -v; }
show 'env -u NO_COLOR TERM=xterm'
show 'env NO_COLOR=1 TERM=xterm'
show 'env -u NO_COLOR TERM=dumb'
env -u NO_COLOR TERM=xterm uhas-inspect profile/allegro_right.h5 | head -n 1
#> ^[[1mHand^[[0m    allegro_right, a right hand^M
#> Hand    allegro_right, a right hand^M
#> Hand    allegro_right, a right hand^M
#> Hand    allegro_right, a right hand
