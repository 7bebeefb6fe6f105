#!/bin/sh
# release.sh [WEB PACKAGES...]: makes the files of a release in build/release-VERSION/. Called by ./setup.sh release with
# the packages that the page in WebAssembly needs. A part that cannot be made is named at the end, and the exit code is 1.
set -eu
cd "$(dirname "$0")/.."
web_packages=$*
version=$(sed -n 's/^project(csgsim VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
out=build/release-$version
# shellcheck disable=SC1091
debian=$(. /etc/os-release && echo "$ID-${VERSION_ID:-unstable}")

refuse() {
  echo "release.sh: $*" >&2
  exit 1
}

# Compresses a tar archive; equal content makes an equal file.
compressed() { gzip -9n >"$out/$1"; }

# packed FOLDER NAME: archives build/FOLDER as NAME.tar.gz.
packed() {
  tar -C build --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" \
    --transform "s,^$1,$2," -cf - "$1" | compressed "$2.tar.gz"
}

source_archive() { git archive --format=tar --prefix="csgsim-$version/" HEAD | compressed "csgsim-$version.tar.gz"; }

debian_packages() {
  ./setup.sh package &&
    mkdir -p "$out/$debian" &&
    cp build/csgsim_"$version"_*.deb build/libcsgsim-dev_"$version"_*.deb build/python3-csgsim_"$version"_*.deb "$out/$debian"
}

# The wheel of the Python module that the packages contain.
python_wheel() {
  mkdir -p "$out/$debian" &&
    env CSGSIM_BUILD=build/package python3 -m pip wheel --quiet --no-build-isolation --no-deps --wheel-dir "$out/$debian" .
}

site() {
  ./setup.sh site && packed site "csgsim-$version-site" && cp build/csgsim.pdf "$out/csgsim-$version.pdf"
}

web_page() {
  absent=""
  for package in $web_packages; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || absent="$absent $package"
  done
  if [ -n "$absent" ]; then
    echo "these packages are missing:$absent; ./setup.sh web installs them" >&2
    return 1
  fi
  ./setup.sh web && packed web "csgsim-$version-web"
}

git rev-parse --git-dir >/dev/null 2>&1 || refuse "this is not a git clone, from which the source archive is made"
git diff --quiet HEAD -- || refuse "files differ from the last commit, which the source archive has; commit them first"
rm -rf "$out"
mkdir -p "$out"
failed=""
for part in source_archive debian_packages python_wheel site web_page; do
  printf '\n== %s\n' "$part"
  "$part" || failed="$failed $part"
done
(cd "$out" && find . -type f -printf '%P\n' | LC_ALL=C sort | xargs -d '\n' sha256sum) >build/SHA256SUMS
mv build/SHA256SUMS "$out"
printf '\n== %s\n' "$out"
cat "$out/SHA256SUMS"
[ -z "$failed" ] || refuse "these parts are missing:$failed"
