#!/usr/bin/env bash
# leaderboard_script_test.sh ROOT PROGRAM: leaderboard.sh drives what is missing, and what was interrupted again.
set -euo pipefail
export BANDWAGON_LAB=$2 BANDWAGON_SHARED='' BANDWAGON_JOBS=1
"$2" --version | grep -q 'page of' || { echo "skipped: the page is not in the program" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "leaderboard_script_test: $*" >&2 && exit 1; }

"$1/launch_scripts/leaderboard.sh" "$work" 1 orca_holonomic >"$work/first"
[[ $(wc -l <"$work/cpu.txt") == 4 ]] || fail "four suites of CrowdNav, not: $(cat "$work/cpu.txt")"
mv "$work/crowdnav_circle-orca_holonomic.json" "$work/crowdnav_circle-orca_holonomic.part"
"$1/launch_scripts/leaderboard.sh" "$work" 1 orca_holonomic >"$work/second"
[[ $(wc -l <"$work/cpu.txt") == 5 ]] || fail "one suite was missing, driven were: $(cat "$work/cpu.txt")"
cmp "$work/first" "$work/second" || fail "driven again it is another table"
[[ -s $work/index.html ]] || fail "no page"
