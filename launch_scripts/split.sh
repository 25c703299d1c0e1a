#!/usr/bin/env bash
# Runs a graph with one OS process per `process:` of the graph: split.sh GRAPH [options of `bandwagon run`].
# Ends when the first process ends, or on Ctrl-C; the robot is stopped first. Exit status: the worst of all processes.
# Logs, score card and a manifest of the run: run/<graph>-<time>/, or BANDWAGON_LOG_DIR.
# --record FILE and how it is split: `bandwagon record --all` as one more process, which hears the others; it ends last.
set -euo pipefail
umask 077 # logs hold the page's token, recordings who was where

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${BANDWAGON_PROGRAM:-$root/build/release/bin/bandwagon}
if (($# == 0)); then
  echo "usage: $0 GRAPH [options of bandwagon run]" >&2
  exit 2
fi
graph=$1
shift

asked="$*"
arguments=()
record=()
while (($# > 0)); do
  case $1 in
    --record=*) record+=(--out "${1#*=}") ;;
    --record) record+=(--out "${2:?"--record needs a file"}") && shift ;;
    -b?* | -d?* | --split-size=* | --split-duration=* | --max-size=* | --compression=*) record+=("$1") ;;
    -b | --split-size | -d | --split-duration | --max-size | --compression) record+=("$1" "${2:?"$1 needs a value"}") && shift ;;
    --html | --html=*)
      echo "--html is of one process: record with --record FILE, then: $program view FILE" >&2
      exit 2
      ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
set_options=()
for ((i = 0; i < ${#arguments[@]}; i++)); do
  case ${arguments[i]} in
    --set) set_options+=(--set "${arguments[i + 1]:?"--set needs component.param=value"}") ;;
    --set=*) set_options+=("${arguments[i]}") ;;
    --emulate) set_options+=(--set emulate=true) ;;
    --page | --page=* | --bags | --bags=* | --listen | --listen=* | --token-file | --token-file=* | --allow-*)
      set_options+=(--set viewer.enabled=true) # as the program does
      ;;
  esac
done
processes=$("$program" graph "$graph" "${set_options[@]}" --processes)

logs=${BANDWAGON_LOG_DIR:-$root/run/$(basename "$graph" .yaml)-$(date +%Y%m%d-%H%M%S)}
mkdir -p "$logs"
{
  echo "version: $("$program" --version)"
  echo "revision: $(git -C "$root" rev-parse HEAD 2>/dev/null || echo unknown)"
  echo "graph: $graph"
  printf 'arguments: %s\n' "$asked"
} >"$logs/manifest.yaml"
cp "$graph" "$logs/graph.yaml"
"$program" param dump "$graph" "${set_options[@]}" >"$logs/parameters.yaml"

declare -A process_of
recorder=
# What comes while processes are started waits until all of them can be told.
asked_to_end=0
trap 'asked_to_end=1' INT TERM HUP
interrupted=0
interrupt_all() {
  # Once: a second one would end a process before its robot stands. SIGTERM: SIGINT is ignored by what a script starts beside
  # itself until that has its handlers.
  ((interrupted)) && return
  interrupted=1
  for pid in "${!process_of[@]}"; do kill -TERM "$pid" 2>/dev/null || true; done
}

if ((${#record[@]})); then
  setsid "$program" record --all "${record[@]}" > >(tee "$logs/recorder.out") 2> >(tee "$logs/recorder.log" >&2) &
  recorder=$!
  echo "recorder: pid $recorder" >>"$logs/manifest.yaml"
fi
for process in $processes; do
  ((asked_to_end)) && break
  json=()
  [[ " ${arguments[*]} " == *" --json"[\ =]* ]] || json=(--json "$logs/$process.json")
  # In a group of its own, so that Ctrl-C reaches it once, through this script.
  setsid "$program" run "$graph" --only "$process" "${json[@]}" "${arguments[@]}" \
    > >(tee "$logs/$process.out") 2> >(tee "$logs/$process.log" >&2) &
  process_of[$!]=$process
  echo "$process: pid $!" >>"$logs/manifest.yaml"
done
trap interrupt_all INT TERM HUP
((asked_to_end)) && interrupt_all

worst=0
collect() { # NAME STATUS
  (($2 > worst)) && worst=$2
  echo "$1: exit status $2" >>"$logs/manifest.yaml"
}
# `ended` and its `status`. What ended before `wait -n` is asked, it does not tell of.
wait_for_one() {
  local pid
  status=0
  for pid in "${!process_of[@]}" $recorder; do
    kill -0 "$pid" 2>/dev/null && continue
    ended=$pid
    wait "$pid" || status=$?
    return 0
  done
  wait -n -p ended "${!process_of[@]}" $recorder || status=$?
}
while ((${#process_of[@]} > 0)); do
  wait_for_one
  [[ -n ${ended:-} ]] || continue # a signal came: the trap has passed it on
  collect "${process_of[$ended]:-recorder}" "$status"
  [[ $ended != "$recorder" ]] || recorder=
  unset "process_of[$ended]"
  interrupt_all
done
if [[ -n $recorder ]]; then
  kill -TERM "$recorder"
  status=0
  wait "$recorder" || status=$?
  collect recorder "$status"
fi
echo "Logs: $logs"
exit "$worst"
