#!/usr/bin/env bash
# package.sh [--arm64] [FOLDER]: the Debian packages of this commit, for the Debian that it runs on, into FOLDER (build/packages). Installs what is
# missing, builds program and lab in build/release, packs, and lets lintian look. The same commit gives the same bytes on the same Debian.
# --arm64: for boards with a 64-bit ARM, built here with Debian's cross compiler in build/arm64 (program alone; as root, or with sudo: it adds
# the architecture to dpkg).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
arm64=false
if [[ ${1:-} == --arm64 ]]; then
  arm64=true
  shift
fi
if [[ ${1:-} == -* ]]; then
  sed -n '2,5s/^# //p' "$0" >&2
  exit 2
fi
out=$(realpath -m -- "${1:-$root/build/packages}")
cd "$root"

# 0.1.0 where the commit has that tag; else a version that is newer with each commit: 0.1.0+20261127.041200.abfc3b31
version=$(sed -n 's/^project(bandwagon VERSION \([^ ]*\).*/\1/p' CMakeLists.txt)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH TZ=UTC
[[ $(git describe --tags --exact-match 2>/dev/null || true) == "v$version" ]] ||
  version+=+$(git log -1 --date=format:%Y%m%d.%H%M%S --format=%cd.%h --abbrev=8)
# shellcheck source=/dev/null
version+="~$(. /etc/os-release && echo "$ID${VERSION_ID//./}")"
[[ -z $(git status --porcelain) ]] || echo "The work tree has changes that the packages' version does not tell." >&2

debian=(-DBANDWAGON_DEBIAN=ON -DBANDWAGON_PACKAGE_VERSION="$version" -DCMAKE_INSTALL_PREFIX=/usr)
if $arm64; then
  "$root/launch_scripts/setup.sh" arm64
  build=$root/build/arm64
  mkdir -p "$build"
  # The compiler of the messages runs here. By itself: libceres-dev of two processors do not go beside each other.
  messages=$build/bandwagon_idl_compiler
  c++ -std=c++20 -O1 -I. -DBANDWAGON_VERSION="\"${version%%[+~]*}\"" -o "$messages" idl/compiler/*.cpp -lcrypto
  triplet=aarch64-linux-gnu architecture=arm64
  PKG_CONFIG_LIBDIR=/usr/lib/$triplet/pkgconfig cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBANDWAGON_TESTS=OFF \
    -DCMAKE_TOOLCHAIN_FILE="$root/cmake/arm64.cmake" -DBANDWAGON_IDL_COMPILER="$messages" >/dev/null
  echo "Building the program for arm64 ..."
  cmake --build "$build" -j "${BANDWAGON_JOBS:-2}" --target bandwagon
  export DEB_HOST_ARCH=$architecture # whose libraries' packages are looked up
else
  "$root/launch_scripts/setup.sh" package
  "$root/launch_scripts/build.sh" release program
  "$root/launch_scripts/build.sh" release lab
  build=$root/build/release
  triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
  architecture=$(dpkg-architecture -qDEB_HOST_ARCH)
fi

# From here on the folder installs as a package does; afterwards as it did before.
back() { cmake -S "$root" -B "$build" -DBANDWAGON_DEBIAN=OFF -DCMAKE_INSTALL_PREFIX=/usr/local -U CMAKE_INSTALL_LIBDIR >/dev/null; }
trap back EXIT
cmake -S . -B "$build" "${debian[@]}" -DCMAKE_INSTALL_LIBDIR="lib/$triplet" >/dev/null
cmake --build "$build" -j "${BANDWAGON_JOBS:-2}" --target bandwagon_documents
mkdir -p "$out"
rm -f "$out"/bandwagon*_"$architecture".deb "$out"/bandwagon*_all.deb
(cd "$build" && cpack -B "$out" --config CPackConfig.cmake) >"$build/cpack.log" 2>&1 || {
  cat "$build/cpack.log"
  exit 1
}
rm -rf "$out/_CPack_Packages"
ls -l "$out"/*.deb
lintian --fail-on error --show-overrides "$out"/*.deb
