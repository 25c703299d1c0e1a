#!/usr/bin/env bash
# battery_short.sh ROOT BANDWAGON_LAB: some rows of the battery, a few repetitions each; a second call takes what the first kept, and what
# was not run is said to be so.
set -euo pipefail
root=$1 lab=$2
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

battery() { "$lab" battery --table "$root/tests/README.md" --trials 6 --out "$out/battery" "$@"; }
battery --rows 6,7,8,12,13 | tee "$out/first"
grep -q 'not run' "$out/first"
battery --rows 33 2>"$out/said" | tee "$out/second"
! grep -q 'row 6:' "$out/said" || { echo 'row 6 ran a second time' >&2; exit 1; }
grep -qE '^ +6 .*trials' "$out/second"
