#!/usr/bin/env bash
# coming_and_going.sh BUILD GRAPH [LOOKS [LEAVINGS]]: how a graph in real time looks to who comes, and how long it takes to leave.
# First the share of newcomers that know all nodes and ends after the half second that ros2's tools take (--no-daemon); then the
# time from SIGINT to the exit, alone, with a page, recorded, and split in processes. On a domain of its own: ROS_DOMAIN_ID.
set -euo pipefail
set -m # else what is started beside a script ignores SIGINT

build=$(realpath "$1")
graph=$(realpath "$2")
looks=${3:-100}
leavings=${4:-20}
program=$build/bin/bandwagon
newcomer=$build/tests/interop/plain/plain_newcomer
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" run "$graph" --stay >/dev/null 2>&1 &
robot=$!
sleep 6
"$newcomer" 5 | cut -d" " -f1-4 >"$folder/all"
for ((i = 0; i < looks; i++)); do "$newcomer" 0.5 | cut -d" " -f1-4; done >"$folder/looks"
kill -INT $robot
wait $robot || true
echo "$(cat "$folder/all"): known to $(grep -cxFf "$folder/all" "$folder/looks" || true) of $looks newcomers after 0.5 s"

leave() { # WORDS DRIVEN_S COMMAND...
  local words=$1 driven=$2
  shift 2
  for ((i = 0; i < leavings; i++)); do
    "${@//@/$folder/$words.$i}" >/dev/null 2>&1 &
    local pid=$! begun
    sleep "$driven"
    begun=$(date +%s%N)
    kill -INT $pid
    wait $pid || true
    echo $((($(date +%s%N) - begun) / 1000000))
  done | sort -n >"$folder/times"
  echo "$words: SIGINT to exit median $(sed -n "$(((leavings + 1) / 2))p" "$folder/times") ms, at most $(tail -1 "$folder/times") ms"
}
leave alone 6 "$program" run "$graph" --stay
leave page 6 "$program" run "$graph" --stay --page --set viewer.port=0
leave record 6 "$program" run "$graph" --stay --record @
leave split 8 "$program" launch "$graph" --logs "$folder/logs" --stay
