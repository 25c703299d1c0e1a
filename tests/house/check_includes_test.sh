#!/usr/bin/env bash
# check_includes.sh refuses a file that relies on another's includes, names it, and is content with what it reaches through the project.
set -euo pipefail
check=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/check_includes.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/components/a"
printf '#include <vector>\n' >"$house/components/a/list.hpp"
printf '#include "components/a/list.hpp"\n// std::map<int, int>\nstd::vector<int> numbers;\nauto text = "std::set<int>";\n' \
  >"$house/components/a/sound.cpp"
"$check" "$house" >/dev/null

printf '#include "components/a/list.hpp"\n\nstd::optional<int> broken;\nEigen::Vector2d place;\n' >"$house/components/a/broken.cpp"
status=0
said=$("$check" "$house") || status=$?
for expected in 'components/a/broken.cpp:3: includes no <optional>' 'components/a/broken.cpp:4: includes no <Eigen/...>'; do
  if ((status == 0)) || ! grep -qF "$expected" <<<"$said"; then
    printf 'expected a failure with "%s", got exit status %d and:\n%s\n' "$expected" "$status" "$said" >&2
    exit 1
  fi
done

rm "$house/components/a/broken.cpp"
printf '#include <CLI/App.hpp>\n' >"$house/components/a/options.cpp"
status=0
said=$("$check" "$house" 2>&1) || status=$?
if ((status == 0)) || ! grep -qF 'components/a/options.cpp' <<<"$said"; then
  printf 'expected CLI11 to be refused, got exit status %d and:\n%s\n' "$status" "$said" >&2
  exit 1
fi
