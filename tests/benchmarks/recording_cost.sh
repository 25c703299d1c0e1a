#!/usr/bin/env bash
# What a recording costs while the robot drives through the hallway in real time: recording_cost.sh [RUNS] [option ...]
#
# Drives RUNS times (10) without and with a recording, in turns, one run after the other; options go behind those of the run that
# records (default: --record to a folder of this script's own). Prints for each pair the planner's median cycle (CPU of its
# thread), and at the end
#   - the median of the ratios of the planner's medians and 95 % quantiles, with by without,
#   - CPU of the recorder's thread, and of the whole process more than without, as shares of one core,
#   - the process's largest memory more than without.
# BANDWAGON: the program, if it is not build/release/bin/bandwagon.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${BANDWAGON:-$root/build/release/bin/bandwagon}
runs=${1:-10}
shift || true
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
record=("$@")
((${#record[@]})) || record=(--record "$folder/drive")

run() { # run NAME [options]
  local name=$1
  shift
  rm -rf "$folder/drive"
  "$program" run "$root/config/graphs/hallway.yaml" --seed 7 --json "$folder/$name.json" "$@" >/dev/null 2>"$folder/$name.log" ||
    { cat "$folder/$name.log" >&2; exit 1; }
}

echo "load average before: $(cut -d ' ' -f 1-3 /proc/loadavg), $(nproc) cores"
for ((i = 0; i < runs; i++)); do
  # Either goes first every other time.
  if ((i % 2 == 0)); then
    run "without$i"
    run "with$i" "${record[@]}"
  else
    run "with$i" "${record[@]}"
    run "without$i"
  fi
  jq -rn --slurpfile a "$folder/without$i.json" --slurpfile b "$folder/with$i.json" \
    '"\($a[0].planner.median_ms) ms without, \($b[0].planner.median_ms) ms with"'
done
echo "load average after:  $(cut -d ' ' -f 1-3 /proc/loadavg)"

jq -rn --slurpfile a <(cat "$folder"/without*.json) --slurpfile b <(cat "$folder"/with[0-9]*.json) '
  def median: sort | if length % 2 == 1 then .[length / 2 | floor] else (.[length / 2 - 1] + .[length / 2]) / 2 end;
  def percent: . * 10000 | round / 100;
  def digits: . * 1000 | round / 1000;
  def ratio(f): [range($a | length) as $i | ($b[$i] | f) / ($a[$i] | f)] | median | digits;
  def share: [.[] | .process.cpu_s / .real_time_s] | median;
  "planner median, with by without: \(ratio(.planner.median_ms))",
  "planner 95 %, with by without:   \(ratio(.planner.p95_ms))",
  (if $b[0].recording then
    "recorder thread:   \([$b[] | .recording.cpu_s / .real_time_s] | median | percent) % of one core",
    "dropped messages:  \([$b[] | .recording.dropped | add // 0] | add)"
  else empty end),
  "process more:      \(($b | share) - ($a | share) | percent) % of one core",
  "memory more:       \(([$b[] | .process.max_rss_mb] | median) - ([$a[] | .process.max_rss_mb] | median) | digits) MB"
'
