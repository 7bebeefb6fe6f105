#!/bin/sh
# Builds csgsim and runs a command. On Debian it installs missing packages; elsewhere it prints how to install them.
set -eu
cd "$(dirname "$0")"

usage() {
  cat <<'TEXT'
Usage: ./setup.sh COMMAND
  demo   draw a model at the functional and the cycle level; pictures and counts in build/demo/
  test   build everything and run the whole test suite
  build  build build/release/csgsim
  package
         make the Debian packages csgsim, libcsgsim-dev and python3-csgsim in build/; install them with
         apt install ./build/csgsim*.deb
  release
         make what a release consists of, in build/release-VERSION/: source archive, packages and wheel of this Debian, the
         site, the page in WebAssembly if the packages of web are installed, and SHA256SUMS; name what is missing
  packages [MANAGER]
         print the packages that the program needs to be built, here or with apt, dnf, pacman, zypper, apk or brew
  install-test [bookworm|trixie]
         run demo, test and package in a Debian 12 or 13, downloaded into a chroot, install the packages in another,
         minimal one, and draw there; the log is build/install-test.log
  container-test
         carry out the Containerfile in chroots, without a container engine, and draw; the log is
         build/container-test.log
  asan [core]
         build everything with clang, warnings as errors, with address and undefined-behaviour sanitizers, and run the
         suite; with core, only the tests of reading files, compiling and simulating
  fuzz MINUTES [RUNS]
         build the fuzzers and run them for MINUTES in total, each for at most RUNS cases
  nightly [HOURS]
         repeat all property tests with random seeds, which are printed, for HOURS (default 2); failures and the commands
         that repeat them are written to build/release/nightly/, and the exit code is 1 if there are any
  tsan   run the tests of multi-threaded code under the thread sanitizer
  flags  build without optimisation, and for this processor, and compare both with the golden results
  faults fail every write, fsync and rename of every command, one at a time, and print the results
  bench  build and run the benchmarks of kernels
  performance [OTHER]
         measure the numbers of docs/performance.md here, and write its tables and plots; with OTHER, the csgsim of an
         older commit, measure both in turns
  docs [OPTIONS...]
         regenerate every number, table and picture of README.md and docs/, and show the changes; with --exact only those
         independent of the computer's speed, with --page NAME only one page; more: tests/docs/make.py --help
  web    compile the page of view to WebAssembly: build/web/, for any static server, without a server program; test it in
         node and in a Chromium (300 MB); more: docs/view.md
  site   convert the pages to a book: build/site/index.html with a search, and build/csgsim.pdf
  reproduce
         recompute every table of the thesis, ours next to the original, and show the changes: docs/reproduction.md
  rtl    compare the machine in Verilog with csgsim: all designs in Icarus and Verilator, and all proofs; and place and
         route the FPGA designs of docs/hardware.md (an hour)
  screenshots
         redraw the pictures of docs/debugging.md: GTKWave, with a wave of each kind of machine
  report-test
         install a Chromium (300 MB) and test the pages of --report and of view in it
  openscad-tests DIR [WORDS...]
         compare pictures of OpenSCAD's own tests and examples with OpenSCAD's meshes: DIR is a checkout made by
         git clone --depth 1 https://github.com/openscad/openscad DIR; WORDS select models by a word in their path
  lint [BASE [MOST]]
         check the formatting (clang-format) and the code (clang-tidy); with BASE, a commit, only code changed since then;
         with MOST, only that number of files, the latest changes first
  cluster
         run a study on a local Slurm with two nodes, kill one of them, and compare with a single process; the same with
         srun, mpirun and GNU Parallel (as root)
  mutate test the tests: 400 small wrong edits, one at a time; more options: tests/mutation/README.md
With CSGSIM_SKIP_PACKAGES=1 in the environment, no command checks or installs packages.
TEXT
}

. cmake/packages.sh

program_groups="build pictures convert text"
# shellcheck disable=SC2086
build_packages=$(packages apt $program_groups python)
test_packages=$(packages apt test)
clang_packages="clang libclang-rt-dev lld"
rtl_packages="make iverilog verilator yosys nextpnr-ice40 fpga-icestorm graphviz"
web_packages="clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 emscripten
  dpkg-dev"

# build PRESET [CMAKE OPTIONS...]; with CSGSIM_STRICT set, warnings are errors in every preset; CSGSIM_COMMIT names the
# commit of sources without git.
build() {
  preset=$1
  shift
  cmake --preset "$preset" ${CSGSIM_STRICT:+-DCMAKE_COMPILE_WARNING_AS_ERROR=ON} \
    ${CSGSIM_COMMIT:+"-DCSGSIM_COMMIT=$CSGSIM_COMMIT"} "$@"
  cmake --build --preset "$preset"
}

# Builds the program with its run-time modules. A build folder configured with tests keeps them, without building them.
program() {
  set --
  [ -e build/release/build.ninja ] || set -- -DCSGSIM_BUILD_TESTS=OFF
  cmake --preset release "$@"
  cmake --build --preset release --target hw/all host/all sim/all
  scratch_folder
}

# The folder in which users type the commands of the pages: what these write stays out of the repository.
scratch_folder() {
  mkdir -p build/try
  for folder in build docs hw tests traces; do ln -sfn "../../$folder" "build/try/$folder"; done
}

# fuzz MINUTES [RUNS]: divides the time among the fuzzers, which run two at a time.
fuzz() {
  case "${1:-}" in
    '' | 0* | *[!0-9]*)
      usage
      exit 2
      ;;
  esac
  # shellcheck disable=SC2086
  need $build_packages $test_packages $clang_packages
  cmake --preset fuzz -DCSGSIM_BUILD_TESTS=ON
  cmake --build --preset fuzz
  fuzzers=$(wc -l <build/fuzz/fuzzers.txt)
  tests/fuzz/run.sh build/fuzz $(($1 * 60 * 2 / fuzzers)) ${2:+"$2"}
}

# nightly [HOURS]
nightly() {
  case "${1:-2}" in
    *[!0-9.]* | *.*.* | .)
      usage
      exit 2
      ;;
  esac
  # shellcheck disable=SC2086
  need $build_packages $test_packages
  build release -DCSGSIM_BUILD_TESTS=ON
  exec python3 tests/nightly/nightly.py build/release --hours "${1:-2}"
}

tsan() {
  # shellcheck disable=SC2086
  need $build_packages $test_packages $clang_packages
  cmake --preset tsan -DCSGSIM_BUILD_TESTS=ON
  cmake --build --preset tsan
  # Disables address-space randomization, which may exceed the sanitizer's shadow memory.
  fixed="setarch $(uname -m) -R"
  $fixed true 2>/dev/null || fixed=""
  $fixed ctest --preset tsan -j "$(nproc)"
}

# sources [BASE [MOST]]: lists the .cpp files to check: all except those compiled only for the web; or those changed
# since a commit, and for each changed header a file that includes it, the latest change first, at most MOST.
sources() {
  git ls-files 'hw/*.cpp' 'host/*.cpp' 'sim/*.cpp' ':!sim/web/lacking' >build/sources
  if [ -z "${1:-}" ]; then
    cat build/sources
    return
  fi
  {
    git diff --name-only --diff-filter=d HEAD -- hw host sim
    git log --format= --name-only "$1"..HEAD -- hw host sim
  } >build/changed
  while read -r file; do
    case "$file" in
      *.cpp) grep -Fx "$file" build/sources || true ;;
      # The header's own source file if it exists, otherwise the first file that includes it.
      *.h) grep -Fx "${file%.h}.cpp" build/sources || xargs grep -lF "#include \"$file\"" <build/sources | head -n 1 ;;
    esac
  done <build/changed | awk -v most="${2:-1000000}" '!seen[$0]++ && count++ < most'
}

lint() {
  # shellcheck disable=SC2086
  need $build_packages $test_packages git clang-format clang-tidy
  if [ -n "${1:-}" ]; then
    git rev-parse --verify --quiet "$1^{commit}" >/dev/null || {
      echo "setup.sh: unknown commit $1; name one that git log shows" >&2
      exit 2
    }
  fi
  git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror
  python3 tests/docs/wording.py
  python3 tests/docs/used_by.py
  if [ -n "${1:-}" ]; then
    long=$(git log --no-merges --format=%s "$1..HEAD" | grep -vE '^[a-z0-9_./, +-]+: [a-z`-].{0,69}$' || true)
    [ -z "$long" ] || {
      printf 'setup.sh: a commit subject is "room: imperative", at most 72 characters; not so:\n%s\n' "$long" >&2
      exit 1
    }
  fi
  cmake --preset lint
  sources "$@" >build/linted
  echo "clang-tidy on $(wc -l <build/linted) files"
  xargs -r -P "$(nproc)" -n 1 clang-tidy -p build/lint --quiet --extra-arg=-Wno-unknown-warning-option <build/linted
}

demo() {
  # shellcheck disable=SC2086
  need $build_packages
  program
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
  echo "Both levels drew identical pictures. In $out/:"
  echo "  functional.png, cycle.png              the picture"
  echo "  functional-depth.exr, cycle-depth.exr  distance from the eye at each pixel"
  echo "  functional-owner.exr, cycle-owner.exr  index of the visible primitive at each pixel"
  echo "  functional.json, cycle.json            every count"
}

# Copies the tables of csgsim_bench between the marks of the page.
performance() {
  # shellcheck disable=SC2086
  need $build_packages $test_packages openscad povray xvfb xauth
  cmake --preset release -DCSGSIM_BUILD_TESTS=ON
  cmake --build --preset release --target csgsim_bench csgsim_pictures_module csgsim_text_module
  out=build/performance
  xvfb-run -a build/release/csgsim_bench measure tests/models/carburettor.csg tests/models/terrain_vehicle.csg tests/models/rietveld_house.csg \
    --rounds 3 ${1:+--beside "$1"} -o "$out"
  awk -v tables="$out/bench.md" '
    /^<!-- end/ { skipping = 0 }
    !skipping { print }
    /^<!-- measured/ { print ""; while ((getline line <tables) > 0) print line; skipping = 1 }
  ' docs/performance.md >"$out/performance.md"
  mkdir -p docs/pictures/performance
  cp "$out"/growth_*.svg docs/pictures/performance/
  mv "$out/performance.md" docs/performance.md
}

# Regenerates the contents of docs/manifest; measured entries and those drawn by other programs need further packages.
docs() {
  # shellcheck disable=SC2086
  need $build_packages $test_packages $rtl_packages libbenchmark-dev python3 git openscad povray gtkwave xvfb xauth imagemagick \
    qflow-tech-osu050
  cmake --preset release -DCSGSIM_BUILD_TESTS=ON -DCSGSIM_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target csgsim csgsim_pictures_module csgsim_text_module csgsim_bench bench_division m68000_clocks
  python3 tests/docs/make.py build/release "$@" || failed=$?
  git --no-pager diff --stat -- README.md docs hw/machines/area_table.h
  return "${failed:-0}"
}

# The site takes about 15 s, the PDF two minutes.
site() {
  need python3 python3-sphinx furo python3-myst-parser weasyprint fonts-dejavu-core fonts-dejavu-extra
  /usr/bin/python3 docs/book/book.py site build/site
  /usr/bin/python3 docs/book/book.py pdf build/site
  ls build/site/index.html build/csgsim.pdf
}

# Downloads the source of Clipper to build/wasm/clipper: the package contains the library only for this architecture.
clipper_source() {
  folder=$PWD/build/wasm/clipper
  ls "$folder"/libpolyclipping-*/cpp/clipper.cpp >/dev/null 2>&1 && return
  mkdir -p "$folder/lists/partial"
  (
    cd "$folder"
    echo "deb-src http://deb.debian.org/debian bookworm main" >sources.list
    options="-o Dir::Etc::SourceList=$folder/sources.list -o Dir::Etc::SourceParts=- -o Dir::State::Lists=$folder/lists"
    # shellcheck disable=SC2086
    apt-get $options update -q
    # shellcheck disable=SC2086
    apt-get $options source -q libpolyclipping
  )
}

web() {
  # shellcheck disable=SC2086
  need $build_packages $web_packages
  clipper_source
  python3 sim/web/build.py build/wasm build/wasm/clipper/libpolyclipping-*/cpp/clipper.cpp
  python3 sim/web/site.py build/wasm/csgsim.wasm build/web
  echo "build/web/ contains a page for any static server: python3 -m http.server --directory build/web"
}

web_test() {
  need python3 nodejs chromium
  program
  python3 tests/web/session_test.py build/release/csgsim . build/web
  python3 tests/web/counts_test.py build/release/csgsim . build/web
  python3 tests/web/page_test.py build/release/csgsim . build/web
}

package() {
  # shellcheck disable=SC2086
  need $build_packages dpkg-dev file
  build package
  rm -rf build/package/packages
  cpack --config build/package/CPackConfig.cmake -B build/package/packages
  rm -f build/csgsim_*.deb build/libcsgsim-dev_*.deb build/python3-csgsim_*.deb
  mv build/package/packages/*.deb build/
  ls -l build/*.deb
  if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning build/csgsim_*.deb build/libcsgsim-dev_*.deb build/python3-csgsim_*.deb
  fi
}

# logged LOG COMMAND...: runs it as root, with its output in build/LOG and on the terminal.
logged() {
  log=build/$1
  shift
  mkdir -p build
  as_root "$@" >"$log" 2>&1 || failed=$?
  cat "$log"
  return "${failed:-0}"
}

# install_test [SUITE]
install_test() {
  suite=${1:-$(. /etc/os-release && echo "${VERSION_CODENAME:-}")}
  case "$suite" in
    bookworm | trixie) ;;
    *)
      echo "setup.sh: install-test takes bookworm (Debian 12) or trixie (Debian 13), not '$suite'" >&2
      exit 2
      ;;
  esac
  need debootstrap git
  logged install-test.log tests/install/bare_debian.sh "$suite"
}

container_test() {
  need debootstrap git
  logged container-test.log tests/install/container.sh
}

case "${1:-}" in
  demo) demo ;;
  package) package ;;
  release)
    need git python3-pip python3-setuptools python3-wheel
    # shellcheck disable=SC2086
    exec cmake/release.sh $web_packages
    ;;
  packages) print_packages "${2:-}" ;;
  install-test) install_test "${2:-}" ;;
  container-test) container_test ;;
  docs)
    shift
    docs "$@"
    ;;
  web)
    web
    web_test
    ;;
  site) site ;;
  reproduce) docs --page docs/reproduction.md --exact ;;
  performance) performance "${2:-}" ;;
  build)
    # shellcheck disable=SC2086
    need $build_packages
    program
    ;;
  test)
    # shellcheck disable=SC2086
    need $build_packages $test_packages
    build release -DCSGSIM_BUILD_TESTS=ON
    scratch_folder
    ctest --preset release -j "$(nproc)"
    ;;
  asan)
    case "${2:-}" in
      '') core=OFF ;;
      core) core=ON ;;
      *)
        usage
        exit 2
        ;;
    esac
    # shellcheck disable=SC2086
    need $build_packages $test_packages $clang_packages
    build asan -DCSGSIM_BUILD_TESTS=ON "-DCSGSIM_CORE_TESTS=$core"
    ctest --preset asan -j "$(nproc)"
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
  faults)
    # shellcheck disable=SC2086
    need $build_packages $test_packages
    build release -DCSGSIM_BUILD_TESTS=ON
    CSGSIM_FAULTS=all build/release/test_faults
    ;;
  bench)
    # shellcheck disable=SC2086
    need $build_packages $test_packages libbenchmark-dev
    build release -DCSGSIM_BUILD_TESTS=ON -DCSGSIM_BUILD_BENCHMARKS=ON
    for benchmark in build/release/bench_*; do "$benchmark"; done
    ;;
  rtl)
    # shellcheck disable=SC2086
    need $build_packages $test_packages $rtl_packages
    build release -DCSGSIM_BUILD_TESTS=ON
    ctest --preset release -L rtl -j "$(nproc)"
    tests/rtl/large.sh build/release
    python3 tests/rtl/formal/formal.py
    for simulator in verilator icarus; do python3 tests/rtl/designs/simulate.py build/release/csgsim $simulator long; done
    python3 tests/rtl/designs/netlist.py build/release/csgsim
    python3 tests/rtl/designs/place.py build/release/csgsim
    git --no-pager diff --stat -- docs sim/rtl
    ;;
  screenshots)
    # shellcheck disable=SC2086
    need $build_packages gtkwave xvfb imagemagick iverilog make python3
    program
    PATH=$PWD/build/release:$PATH tests/waves/screenshots.sh
    ;;
  report-test)
    # shellcheck disable=SC2086
    need $build_packages python3 chromium
    program
    python3 tests/report/pages_test.py build/release/csgsim .
    python3 tests/report/story_test.py build/release/csgsim .
    python3 tests/view/page_test.py build/release/csgsim .
    ;;
  cluster)
    # shellcheck disable=SC2086
    need $build_packages gnuplot-nox slurmctld slurmd slurm-client munge parallel openmpi-bin procps
    program
    as_root tests/cluster/slurm.sh build/release/csgsim build/cluster.log
    ;;
  openscad-tests)
    [ "$#" -ge 2 ] || { usage; exit 2; }
    shift
    # shellcheck disable=SC2086
    need $build_packages python3-numpy openscad
    program
    exec /usr/bin/python3 tests/corpus/openscad_tests.py "$@"
    ;;
  fuzz) fuzz "${2:-}" "${3:-}" ;;
  nightly) nightly "${2:-}" ;;
  tsan) tsan ;;
  lint)
    shift
    lint "$@"
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
