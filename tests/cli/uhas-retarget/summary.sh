# with a file for the result, the summary is what is printed
names=$(/usr/bin/python3 -c 'import json; print(json.dumps([f"{f}_joint_{i}" for f in ("index", "middle", "ring", "thumb") for i in range(4)]))')
echo "{\"format\":\"uhas-trajectory\",\"version\":1,\"joint_names\":$names,\"q\":[]}" > empty.json
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 empty.json -o out.json --json
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 empty.json -o out.json
uhas-retarget --from profile/allegro_right.h5 --to profile/allegro_right.h5 empty.json | grep -v joint_names
#> {
#>   "format": "uhas-retarget-summary",
#>   "version": 1,
#>   "from": "allegro_right",
#>   "to": "allegro_right",
#>   "summary": {
#>     "frames": 0,
#>     "off_manifold": 0,
#>     "tolerance": 0.01,
#>     "residual_rms": 0.0,
#>     "residual_max": 0.0,
#>     "worst_frame": null
#>   }
#> }
#> Retargeted 0 frames from allegro_right to allegro_right
#> {
#>   "format": "uhas-trajectory",
#>   "version": 1,
#>   "hand": "allegro_right",
#>   "summary": {
#>     "frames": 0,
#>     "off_manifold": 0,
#>     "tolerance": 0.01,
#>     "residual_rms": 0.0,
#>     "residual_max": 0.0,
#>     "worst_frame": null
#>   },
#>   "q": [],
#>   "residual_max": [],
#>   "residual_rms": []
#> }
