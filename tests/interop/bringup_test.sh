#!/usr/bin/env bash
# bringup_test.sh ROOT PROGRAM: launch_scripts/bringup.sh without hardware: what it refuses, and one run with emulators from the first line to rest.
# shellcheck source=tests/interop/bringup_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/bringup_common.sh"
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

# shellcheck disable=SC2119  # no options
up
grep -q '^base: pid' "$folder/logs/manifest.yaml" || fail "the base has no process of its own"
# What config/robots/README.md has its reader type while the robot is up, and what it says of the answers.
answers 'is_latched: false' topic echo /base_state --once --for 30
answers 'child_frame_id: base_link' topic echo /odom --once --for 30
answers 'success: true' service call /release_stop
answers 'real-time\|memory' doctor --ports
down
mapfile -t ids < <(sed -n 's/.*: pid //p' "$folder/logs/manifest.yaml")
((${#ids[@]} >= 4)) || fail "fewer than four processes: ${ids[*]}"
for id in "${ids[@]}"; do
  ! kill -0 "$id" 2>/dev/null || fail "process $id is left"
done
! grep -l 'no fresh wheel command' "$folder"/logs/base.log || fail "the base ran out of commands"
echo "refusals, and a run of ${#ids[@]} processes from start to rest"
