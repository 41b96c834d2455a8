cp -rL hand copy
sed 's/<robot name="[^"]*"/<robot name="a\/b"/' hand/allegro_right.urdf > copy/hand.urdf
uhas-build-profile copy/hand.urdf | tail -n 1
#> Wrote a_b.h5
