#!/usr/bin/env bash
# build.sh [PRESET] [program|lab|tests|idl_compiler]: configures and builds a preset (default: release, tests: everything).
# A new build folder that is asked for the program alone needs neither GoogleTest nor Benchmark; tests that a folder once had stay.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}
what=${2:-tests}
cd "$root"

options=()
targets=()
new=false
[[ -f build/$preset/CMakeCache.txt ]] || new=true
case $what in
  program)
    $new && options+=(-DBANDWAGON_TESTS=OFF)
    targets=(--target bandwagon)
    echo "Building the program, $preset (from scratch: about 10 minutes on two cores) ..."
    ;;
  lab)
    $new && options+=(-DBANDWAGON_TESTS=OFF)
    targets=(--target bandwagon-lab)
    echo "Building the lab: evaluate, bench, reproduce, bag import, $preset ..."
    ;;
  idl_compiler)
    $new && options+=(-DBANDWAGON_TESTS=OFF)
    targets=(--target bandwagon_idl_compiler)
    echo "Building the compiler of the messages, $preset ..."
    ;;
  tests)
    options+=(-DBANDWAGON_TESTS=ON)
    echo "Building the program, its tests and benchmarks, $preset (from scratch: up to 20 minutes on two cores) ..."
    ;;
  *)
    echo "usage: $0 [PRESET] [program|lab|tests|idl_compiler]" >&2
    exit 2
    ;;
esac
# Only a new folder gets ccache: another launcher would compile everything again.
if $new && command -v ccache >/dev/null; then
  # What ccache must overlook before it touches a source that uses a precompiled header.
  launcher='env;CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;ccache'
  options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher" -DCMAKE_C_COMPILER_LAUNCHER=ccache)
fi

SECONDS=0
cmake --preset "$preset" "${options[@]}" >/dev/null
cmake --build --preset "$preset" -j "${BANDWAGON_JOBS:-2}" "${targets[@]}"
printf 'Built in %d min %02d s.\n' $((SECONDS / 60)) $((SECONDS % 60))
