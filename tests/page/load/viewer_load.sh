#!/usr/bin/env bash
# A hundred clients beside a robot that drives through the hallway in real time: viewer_load.sh [PAIRS [SECONDS]]
#
# First one drive of SECONDS (60) with the load: updates that each healthy client received, their delays, the viewer's memory. Then PAIRS (5) of drives with
# and without it, either first every other time: the planner's cycles (CPU of its thread), pooled. Needs jq; by in_test_environment.
# BANDWAGON_BUILD: the build folder, if it is not build/release.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
build=${BANDWAGON_BUILD:-$root/build/release}
pairs=${1:-5}
seconds=${2:-60}
folder=$(mktemp -d)
robot=
finish() {
  [[ -z $robot ]] || kill -INT "$robot" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT

# drive NAME SECONDS with|without: the hallway at 0.3 m/s, which takes more than a minute, for so long.
drive() {
  local port
  "$build/bin/bandwagon" run "$root/config/graphs/hallway.yaml" --seed 7 --page=0 --set robot.limits.v_max=0.3 --for "$(($2 + 6))" \
    --json "$folder/$1.json" >"$folder/$1.out" 2>"$folder/$1.log" &
  robot=$!
  until port=$(grep -oE '://127\.0\.0\.1:[0-9]+' "$folder/$1.out" | head -1 | grep -oE '[0-9]+$'); do
    kill -0 "$robot" || { cat "$folder/$1.log" >&2; exit 1; }
    read -rt 0.1 <> <(:) || true
  done
  [[ $3 == without ]] || "$build/bin/viewer_load" --port "$port" --seconds "$2" --robot "$robot" >"$folder/$1.load"
  wait "$robot" || true # the goal is farther away
  robot=
}

echo "load average before: $(cut -d ' ' -f 1-3 /proc/loadavg), $(nproc) cores"
drive once "$seconds" with
cat "$folder/once.load"
for ((i = 0; i < pairs; i++)); do
  order=(with without)
  ((i % 2 == 0)) || order=(without with)
  for which in "${order[@]}"; do drive "$which$i" "$seconds" "$which"; done
  jq -rn --slurpfile a "$folder/without$i.json" --slurpfile b "$folder/with$i.json" \
    '"pair: \($a[0].planner.mean_ms) ms without, \($b[0].planner.mean_ms) ms with"'
done
((pairs == 0)) || jq -rn --slurpfile a <(cat "$folder"/without*.json) --slurpfile b <(cat "$folder"/with[0-9]*.json) '
  def pooled: ([.[] | .planner.mean_ms * .planner.cycles] | add) / ([.[] | .planner.cycles] | add);
  "CPU of the planner'"'"'s cycle, pooled: \($a | pooled) ms without, \($b | pooled) ms with, ratio \(($b | pooled) / ($a | pooled))"'
echo "load average after:  $(cut -d ' ' -f 1-3 /proc/loadavg)"
