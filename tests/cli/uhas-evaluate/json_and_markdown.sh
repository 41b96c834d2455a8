uhas-evaluate profile/allegro_right.h5 --json --markdown
#? 2
#2> uhas-evaluate: error: --markdown: cannot be printed as JSON too; see uhas-evaluate --help
