#!/usr/bin/env bash
# bringup_test.sh ROOT PROGRAM: launch_scripts/bringup.sh without hardware: what it refuses, and one run with emulators from the first line to rest.
set -euo pipefail
root=$1
bringup=$root/launch_scripts/bringup.sh
program=$2
export BANDWAGON_PROGRAM=$program
folder=$(mktemp -d)
running=
clean_up() {
  [[ -z $running ]] || kill -TERM "$running" 2>/dev/null || true
  [[ -z $running ]] || wait "$running" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
fail() {
  echo "FAILED: $1"
  [[ ! -s $folder/out ]] || tail -n 40 "$folder/out"
  exit 1
}
refused() { # refused STATUS WORDS ARGUMENTS...
  local status=0
  "$bringup" "${@:3}" >"$folder/out" 2>&1 || status=$?
  [[ $status == "$1" ]] || fail "status $status instead of $1: ${*:3}"
  grep -qF -- "$2" "$folder/out" || fail "does not say '$2': ${*:3}"
}

refused 2 'usage:'
refused 2 'No such robot file: nothing.yaml' nothing.yaml
refused 2 'There are: config/robots/eddie.yaml' nothing.yaml
refused 2 'The robot file comes first' --emulate
refused 2 'No such map' "$root/config/robots/kobuki.yaml" --map "$folder/none.yaml"
refused 2 'nowhere' "$root/config/robots/kobuki.yaml" --set=nowhere.x=1
refused 2 '--map needs a file' "$root/config/robots/kobuki.yaml" --map
printf 'name: X\nwheel_radios: 1\n' >"$folder/robot.yaml"
refused 2 "wheel_radius" "$folder/robot.yaml"
# A robot that is not there: the port, what to do, and where the rule file is.
sed 's#/dev/kobuki#/dev/no-kobuki-here#' "$root/config/robots/kobuki.yaml" >"$folder/absent.yaml"
refused 1 'robot.base: /dev/no-kobuki-here at 115200 bit/s: no such device' "$folder/absent.yaml"
grep -qF 99-bandwagon.rules "$folder/out" || fail "does not name the rule file"

seen() { # seen WORDS: in its output, within a minute
  local i
  for ((i = 0; i < 600; i++)); do
    grep -qF -- "$1" "$folder/out" && return
    kill -0 "$running" 2>/dev/null || return 1
    read -rt 0.1 <> <(:) || true
  done
  return 1
}
BANDWAGON_LOG_DIR=$folder/logs "$bringup" "$root/config/robots/kobuki.yaml" --emulate --no-page >"$folder/out" 2>&1 &
running=$!
seen 'Up: base, laser and all components.' || fail "is not up"
grep -q '^base: pid' "$folder/logs/manifest.yaml" || fail "the base has no process of its own"
# What config/robots/README.md has its reader type while the robot is up, and what it says of the answers.
answers() { # answers WORDS COMMAND...
  "$program" "${@:2}" >"$folder/answer" 2>&1 || fail "status $? of ${*:2}: $(cat "$folder/answer")"
  grep -q -- "$1" "$folder/answer" || fail "'${*:2}' does not say '$1': $(cat "$folder/answer")"
}
answers 'is_latched: false' topic echo /base_state --once --for 30
answers 'child_frame_id: base_link' topic echo /odom --once --for 30
answers 'success: true' service call /release_stop
answers 'real-time\|memory' doctor --ports
kill -TERM "$running"
status=0
wait "$running" || status=$?
running=
((status == 0)) || fail "status $status after it was stopped"
mapfile -t ids < <(sed -n 's/.*: pid //p' "$folder/logs/manifest.yaml")
((${#ids[@]} >= 4)) || fail "fewer than four processes: ${ids[*]}"
for id in "${ids[@]}"; do
  ! kill -0 "$id" 2>/dev/null || fail "process $id is left"
done
! grep -l 'no fresh wheel command' "$folder"/logs/base.log || fail "the base ran out of commands"
echo "refusals, and a run of ${#ids[@]} processes from start to rest"
