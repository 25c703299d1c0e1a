#!/usr/bin/env bash
# check_hazards.sh refuses each kind of broken row, and names it.
set -euo pipefail
check=$(dirname "${BASH_SOURCE[0]}")/check_hazards.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/tests"
printf 'TEST_F(Guard,\n       Stops) {}\nTEST(Mux, Latches) {}\n' >"$house/tests/a_test.cpp"

table() { # table ROW...
  printf '| row | hazard | barrier | figure | test | what remains |\n|---|---|---|---|---|---|\n' >"$house/tests/README.md"
  printf '%s\n' "$@" >>"$house/tests/README.md"
}
expect() { # expect TEXT ROW...: the check fails and says TEXT
  local said status=0
  table "${@:2}"
  said=$("$check" "$house") || status=$?
  if ((status == 0)) || ! grep -qF "$1" <<<"$said"; then
    printf 'expected a failure with "%s", got exit status %d and:\n%s\n' "$1" "$status" "$said" >&2
    exit 1
  fi
}

first='| 1 | h | b | f | `Guard.Stops`, `tests/a_test.cpp` | nothing |'
table "$first" '| 2 | h | b | f | open | all |' '| 3 | h | b | f | `Mux.Latches` | open: the rest |'
"$check" "$house" >/dev/null
expect 'row 2: there is no test Guard.Starts' "$first" '| 2 | h | b | f | `Guard.Starts` | - |'
expect 'row 2: there is no file tests/b_test.cpp' "$first" '| 2 | h | b | f | `tests/b_test.cpp` | - |'
expect 'row 2: has no test and does not say "open"' "$first" '| 2 | h | b | f | shown by hand | - |'
expect 'row 3: should be row 2' "$first" '| 3 | h | b | f | open | - |'
expect 'row 2: has not six columns' "$first" '| 2 | h | b | f | open |'
expect 'row 2: has an empty column' "$first" '| 2 | h | | f | open | - |'
rm "$house/tests/README.md" && touch "$house/tests/README.md"
if "$check" "$house" >/dev/null; then exit 1; fi
