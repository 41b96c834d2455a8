uhas-solve - --profile profile/allegro_right.h5 --html report.html
#? 2
#2> uhas-solve: error: --html: needs a file of actions; see uhas-solve --help
