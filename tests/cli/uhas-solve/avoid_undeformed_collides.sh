# little and ring finger of this hand meet on the undeformed sphere
shadow=$(readlink -f hand)/../shadow_right/shadow_right.urdf
uhas-build-profile --quiet "$shadow" -o shadow.h5
echo '{"format": "uhas-actions", "version": 1, "actions": [[0,0,0,0,0, 0,0,0,0,0]]}' > actions.json
uhas-solve actions.json --profile shadow.h5 --avoid --collisions --urdf "$shadow" | grep -o '"scaled": .*'
#> "scaled": null,
#2> uhas-solve: warning: left 1 of 1 actions colliding: the hand collides on the undeformed sphere too
