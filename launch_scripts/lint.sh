#!/usr/bin/env bash
# Formatting, static analysis and shell checks of the project's own files. Needs the release build's generated messages.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BANDWAGON_BUILD:-$root/build/release}
cd "$root"
for tool in clang-format clang-tidy shellcheck; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: apt-get install clang-format clang-tidy shellcheck" >&2; exit 2; }
done
shellcheck launch_scripts/*.sh .ci/run
git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
# Each source by itself: precompiled headers are GCC's, and like unity sources they would hide an include that is missing.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
cmake -S . -B "$commands" -G Ninja -DBANDWAGON_PRECOMPILE=OFF -DBANDWAGON_UNITY=OFF >/dev/null
sed -i "s#$commands/idl#$build/idl#g" "$commands/compile_commands.json"
git ls-files 'runtime/*.cpp' 'components/*.cpp' 'idl/*.cpp' 'tests/*.cpp' |
  xargs -P "${BANDWAGON_JOBS:-2}" -n 4 clang-tidy --quiet -p "$commands"
echo "Clean."
