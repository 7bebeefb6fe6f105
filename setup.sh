#!/bin/sh
# Sets csgsim up on Debian 12: installs the packages that are missing, builds, and does what is asked.
set -eu
cd "$(dirname "$0")"

usage() {
  cat <<'TEXT'
Usage: ./setup.sh COMMAND
  demo   draw a model at both fidelity levels; pictures and counts in build/demo/
  test   build everything and run the whole test suite
  build  build build/release/csgsim
  asan   build with address and undefined-behaviour sanitizers and run the suite
  flags  build without optimisation, and for this very processor, and hold both against the golden figures
  bench  build and run the benchmarks
  lint   check the formatting (clang-format) and the code (clang-tidy)
  mutate test the tests: 200 small wrong edits, one at a time; more options: tests/mutation/README.md
TEXT
}

build_packages="g++ cmake ninja-build pkg-config libsystemc-dev libglm-dev libopenimageio-dev libcli11-dev
  tao-pegtl-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libboost-dev libhwy-dev"
test_packages="doctest-dev librapidcheck-dev gnuplot-nox"

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "setup.sh: packages have to be installed and there is no sudo; run this as root once" >&2
    exit 1
  fi
}

# Installs those of the named packages that are not there yet.
need() {
  missing=""
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
  done
  [ -z "$missing" ] && return
  echo "installing:$missing"
  as_root apt-get update -q
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $missing
}

# build PRESET [CMAKE OPTIONS...]
build() {
  preset=$1
  shift
  cmake --preset "$preset" "$@"
  cmake --build --preset "$preset"
}

demo() {
  # shellcheck disable=SC2086
  need $build_packages
  build release -DCSGSIM_BUILD_TESTS=OFF
  out=build/demo
  mkdir -p "$out"
  view="--camera 560,-590,420,-5,0,68 --projection perspective"
  for level in functional cycle; do
    echo
    echo "== terrain_vehicle, $level level"
    # shellcheck disable=SC2086
    build/release/csgsim render tests/models/terrain_vehicle.csg $view --level "$level" -o "$out/$level.png" \
      --depth "$out/$level-depth.exr" --owner "$out/$level-owner.exr" --stats "$out/$level.json"
  done
  cmp "$out/functional.png" "$out/cycle.png"
  echo
  echo "Both levels drew the same picture, byte for byte. In $out/:"
  echo "  functional.png, cycle.png              the picture"
  echo "  functional-depth.exr, cycle-depth.exr  distance from the eye at each pixel"
  echo "  functional-owner.exr, cycle-owner.exr  which primitive is seen at each pixel"
  echo "  functional.json, cycle.json            every count"
}

case "${1:-}" in
  demo) demo ;;
  build)
    # shellcheck disable=SC2086
    need $build_packages
    build release -DCSGSIM_BUILD_TESTS=OFF
    ;;
  test | asan)
    # shellcheck disable=SC2086
    need $build_packages $test_packages
    preset=release
    [ "$1" = asan ] && preset=asan
    build "$preset" -DCSGSIM_BUILD_TESTS=ON
    ctest --preset "$preset" -j "$(nproc)"
    ;;
  flags)
    # shellcheck disable=SC2086
    need $build_packages $test_packages
    for preset in debug native; do
      cmake --preset "$preset" -DCSGSIM_BUILD_TESTS=ON
      cmake --build --preset "$preset" --target test_golden
      ctest --preset "$preset" -R '^golden:'
    done
    ;;
  bench)
    # shellcheck disable=SC2086
    need $build_packages $test_packages libbenchmark-dev
    build release -DCSGSIM_BUILD_TESTS=ON -DCSGSIM_BUILD_BENCHMARKS=ON
    for benchmark in build/release/bench_*; do "$benchmark"; done
    ;;
  lint)
    # shellcheck disable=SC2086
    need $build_packages $test_packages git clang-format clang-tidy
    git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror
    build release -DCSGSIM_BUILD_TESTS=ON
    git ls-files 'hw/*.cpp' 'host/*.cpp' 'sim/*.cpp' | xargs -P "$(nproc)" -n 4 clang-tidy -p build/release --quiet \
      --extra-arg=-Wno-unknown-warning-option
    ;;
  mutate)
    shift
    # shellcheck disable=SC2086
    need $build_packages $test_packages python3
    exec python3 tests/mutation/mutate.py "$@"
    ;;
  *)
    usage
    exit 2
    ;;
esac
