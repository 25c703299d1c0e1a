#!/usr/bin/env bash
# package.sh [FOLDER]: the Debian packages of this commit, for the Debian and the processor that it runs on, into FOLDER (build/packages).
# Installs what is missing, builds, packs, and lets lintian look. The same commit gives the same bytes on the same Debian.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m -- "${1:-$root/build/packages}")
"$root/launch_scripts/setup.sh" package
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

build=$root/build/package
options=(
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)"
  -DBANDWAGON_TESTS=OFF -DBANDWAGON_DEBIAN=ON -DBANDWAGON_PACKAGE_VERSION="$version"
  # Paths of the folder that it is built in are no part of it.
  -DCMAKE_CXX_FLAGS="-ffile-prefix-map=$root=. -Wl,-z,relro" -DCMAKE_EXE_LINKER_FLAGS="-Wl,--build-id=sha1"
)
if command -v ccache >/dev/null && [[ ! -f $build/CMakeCache.txt ]]; then
  launcher='env;CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;ccache'
  options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher")
fi
cmake -S . -B "$build" -G Ninja "${options[@]}" >/dev/null
cmake --build "$build" -j "${BANDWAGON_JOBS:-2}"
mkdir -p "$out"
rm -f "$out"/bandwagon*.deb
(cd "$build" && cpack -B "$out" --config CPackConfig.cmake >/dev/null)
rm -rf "$out/_CPack_Packages"
ls -l "$out"/*.deb
lintian --fail-on error --show-overrides "$out"/*.deb
