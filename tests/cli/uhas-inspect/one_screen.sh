# a five-finger hand: at most 40 lines of 100 columns
uhas-build-profile --quiet hand/../human_right/human_right.urdf -o human.h5 2> /dev/null
uhas-inspect --quiet human.h5 > screen
awk 'length > 100' screen
test "$(wc -l < screen)" -le 40
#> finger  joint                 class         lower, deg  upper, deg  q_open, deg  q_sphere, deg  q_closed, deg
#> pinky   little_mcp_abduction  lateral            -20.0        20.0          0.0            0.0           20.0
#>         little_mcp_flexion    encompassing       -20.0        90.0          0.0           37.1           90.0
#>         little_pip            encompassing         0.0       100.0          0.0           13.7          100.0
#>         little_dip            encompassing         0.0        80.0          0.0           18.6           80.0
#> ring    ring_mcp_abduction    lateral            -20.0        20.0          0.0            0.0           20.0
#>         ring_mcp_flexion      encompassing       -20.0        90.0          0.0           34.3           90.0
#>         ring_pip              encompassing         0.0       100.0          0.0           28.1          100.0
#>         ring_dip              encompassing         0.0        80.0          0.0           22.2           80.0
#> middle  middle_mcp_abduction  lateral            -20.0        20.0          0.0            0.0          -20.0
#>         middle_mcp_flexion    encompassing       -20.0        90.0          0.0           39.9           90.0
#>         middle_pip            encompassing         0.0       100.0          0.0           30.2          100.0
#>         middle_dip            encompassing         0.0        80.0          0.0           22.2           80.0
#> index   index_mcp_abduction   lateral            -20.0        20.0          0.0            0.0          -20.0
#>         index_mcp_flexion     encompassing       -20.0        90.0          0.0           45.0           90.0
#>         index_pip             encompassing         0.0       100.0          0.0           21.8          100.0
#>         index_dip             encompassing         0.0        80.0          0.0           20.3           80.0
#> thumb   thumb_cmc_abduction   encompassing       -10.0        70.0        -10.0           26.3           70.0
#>         thumb_cmc_flexion     lateral            -20.0        25.0          0.0            2.5           25.0
#>         thumb_mcp             encompassing       -10.0        55.0          0.0           16.7           55.0
#>         thumb_ip              encompassing       -15.0        80.0          0.0           30.2           80.0
