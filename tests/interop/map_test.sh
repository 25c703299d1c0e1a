#!/usr/bin/env bash
# map_test.sh BANDWAGON: `bandwagon map` on the bag of a drive, from the first command to the files; and each thing it refuses, with its status.
set -euo pipefail

program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failed=0
refuses() { # refuses STATUS TEXT ARGUMENT...: `bandwagon map ARGUMENT...` says TEXT
  local expected=$1 text=$2 status=0 said
  shift 2
  said=$("$program" map "$@" 2>&1) || status=$?
  [[ $status == "$expected" && $said == *"$text"* ]] && return
  printf 'map %s\n expected: %s, %s\n      got: %s, %s\n' "$*" "$expected" "$text" "$status" "$said"
  failed=1
}

"$program" run hallway --clock lockstep --seed 7 --for 12 --record drive >run.log 2>&1 || true
"$program" map drive -o home --json report.json >report.txt
grep -q "^scans .* used" report.txt
grep -q '"scans_by_odometry_alone": 0' report.json
[[ $(head -c 2 home.pgm) == P5 ]]
grep -q '^resolution: 0.05$' home.yaml
grep -q '^image: "home.pgm"$' home.yaml
# The same bytes again.
"$program" map drive -o home_again >/dev/null
cmp home.pgm home_again.pgm

refuses 2 "home.yaml exists already; --overwrite replaces it" drive -o home
"$program" map drive -o home --overwrite --set slam.resolution=0.1 >/dev/null
grep -q '^resolution: 0.1$' home.yaml
refuses 2 "none.mcap" none.mcap -o new
refuses 2 "there is no folder nowhere" drive -o nowhere/new
refuses 2 "did you mean 'resolution'" drive -o new --set slam.resolutio=0.1
"$program" map drive drive -o two >two.txt # the same drive again: its place is found
grep -q "^map       two.yaml" two.txt
refuses 2 "there is no /other of type sensor_msgs/msg/LaserScan; --scan names one of: /scan" drive -o new --scan /other
[[ ! -e new.yaml && ! -e new.pgm ]]
exit "$failed"
