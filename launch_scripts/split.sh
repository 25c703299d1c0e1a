#!/usr/bin/env bash
# Runs a graph with one OS process per `process:` of the graph: split.sh GRAPH [options of `bandwagon run`].
# Ends when the first process ends, or on Ctrl-C; the robot is stopped first. Exit status: the worst of all processes.
# Logs, score card and a manifest of the run: run/<graph>-<time>/, or BANDWAGON_LOG_DIR.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${BANDWAGON_PROGRAM:-$root/build/release/bin/bandwagon}
if (($# == 0)); then
  echo "usage: $0 GRAPH [options of bandwagon run]" >&2
  exit 2
fi
graph=$1
shift

set_options=()
arguments=("$@")
for ((i = 0; i < ${#arguments[@]}; i++)); do
  [[ ${arguments[i]} == --set ]] && set_options+=(--set "${arguments[i + 1]}")
  [[ ${arguments[i]} == --emulate ]] && set_options+=(--set emulate=true)
  [[ ${arguments[i]} == --page* ]] && set_options+=(--set viewer.enabled=true)
done
processes=$("$program" graph "$graph" "${set_options[@]}" --processes)

logs=${BANDWAGON_LOG_DIR:-$root/run/$(basename "$graph" .yaml)-$(date +%Y%m%d-%H%M%S)}
mkdir -p "$logs"
{
  echo "version: $("$program" --version)"
  echo "revision: $(git -C "$root" rev-parse HEAD 2>/dev/null || echo unknown)"
  echo "graph: $graph"
  printf 'arguments: %s\n' "$*"
} >"$logs/manifest.yaml"
cp "$graph" "$logs/graph.yaml"
"$program" param dump "$graph" "${set_options[@]}" >"$logs/parameters.yaml"

declare -A process_of
interrupted=0
interrupt_all() {
  # Once: a second interrupt would end a process before its robot stands.
  ((interrupted)) && return
  interrupted=1
  for pid in "${!process_of[@]}"; do kill -INT "$pid" 2>/dev/null || true; done
}
trap interrupt_all INT TERM

for process in $processes; do
  json=()
  [[ " ${arguments[*]} " == *" --json "* ]] || json=(--json "$logs/$process.json")
  # In a group of its own, so that Ctrl-C reaches it once, through this script.
  setsid "$program" run "$graph" --only "$process" "${json[@]}" "$@" \
    > >(tee "$logs/$process.out") 2> >(tee "$logs/$process.log" >&2) &
  process_of[$!]=$process
  echo "$process: pid $!" >>"$logs/manifest.yaml"
done

worst=0
collect() {
  local pid=$1 status=$2
  ((status > worst)) && worst=$status
  echo "${process_of[$pid]}: exit status $status" >>"$logs/manifest.yaml"
  unset "process_of[$pid]"
}
while ((${#process_of[@]} > 0)); do
  status=0
  wait -n -p ended "${!process_of[@]}" || status=$?
  [[ -n ${ended:-} ]] || continue # a signal came: the trap has passed it on
  collect "$ended" "$status"
  interrupt_all
done
echo "Logs: $logs"
exit "$worst"
