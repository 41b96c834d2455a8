# The Debian packages that uhas needs, in one place, and how to install those that are missing. Sourced by bash scripts.

uhas_build_packages=(
  g++ cmake ninja-build
  libhdf5-dev                                            # runtime
  liburdfdom-dev libconsole-bridge-dev libtinyxml-dev    # URDF
  libassimp-dev libembree-dev nlohmann-json3-dev         # meshes, rays, hand configs
  libeigen3-dev                                          # axes of a palm's surface
  libmeshoptimizer-dev                                   # meshes for pictures
  libfcl-dev                                             # self-collision
  libnlopt-dev                                           # the best fit there is, for scores
  clang-14 lld-14 wasi-libc libc++-14-dev-wasm32         # the runtime in web pages
  libc++abi-14-dev-wasm32 libclang-rt-14-dev-wasm32
  libjs-three                                            # drawings in web pages
  libcli11-dev                                           # tools
)

uhas_test_packages=(
  doctest-dev mandoc pkg-config
  zsh fish                                               # run the completions
  dpkg-dev doxygen                                       # Debian packages, API reference
  clang-format-14                                        # the layout of the sources
  strace                                                 # what the tools ask of the system
  liborocos-kdl-dev                                      # independent kinematics
  libnlopt-cxx-dev libnlopt-dev                          # independent optimiser
  python3 python3-numpy python3-h5py python3-jsonschema  # second reader of the profile, schema validator
  locales                                                # a decimal comma
  nodejs chromium                                        # reports in a browser
  clang libclang-rt-14-dev                               # fuzz targets
)
# Debian's npm conflicts with packages of nodejs that bring an npm of their own.
command -v npm > /dev/null || uhas_test_packages+=(npm)

uhas_long_form_packages=(lcov valgrind)  # tests/coverage.sh, tests/cli/run_valgrind.sh

# install_missing PACKAGE...: installs those that are not there and asks nothing; does not touch the network when all are.
install_missing() {
  if ! command -v apt-get > /dev/null; then
    echo "not a Debian system: the packages $* are expected to be there under their names on this one" >&2
    return
  fi
  local package missing=() as_root=()
  for package in "$@"; do
    dpkg-query --show --showformat '${db:Status-Status}\n' "$package" 2> /dev/null | grep -qx installed ||
      missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  ((EUID == 0)) || as_root=(sudo)
  echo "installing ${missing[*]}" >&2
  "${as_root[@]}" apt-get -q update >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "${missing[@]}" >&2
}
