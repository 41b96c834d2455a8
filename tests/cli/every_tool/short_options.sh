for tool in $(cd "$(dirname "$(command -v uhas-solve)")" && echo uhas-*); do
  [ "$($tool -V)" = "$($tool --version)" ] || echo "$tool -V"
  [ "$($tool -v -V)" = "$($tool --verbose --version)" ] || echo "$tool -v"
  [ "$($tool -h)" = "$($tool --help)" ] || echo "$tool -h"
done
uhas-build-profile -q hand/allegro_right.urdf --samples 2000 -o hand.h5
