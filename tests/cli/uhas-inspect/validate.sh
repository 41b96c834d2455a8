uhas-inspect profile/allegro_right.h5 --validate
#> check        result  found
#> file         ok      whole, of a version this tool reads, all values in range
#> zero action  ok      returns the wrapped pose
