#!/usr/bin/env bash
# Brings a real robot up: bringup.sh ROBOT.yaml [--map MAP.yaml | --slam] [--emulate] [--no-page] [options of `bandwagon run`]
#
# Looks whether the program is built and the robot's ports can be opened (and says what to do), starts config/graphs/robot.yaml with
# one process per `process:`, the base in one of its own, waits until everything is up, and prints the page's address. Ctrl-C brings
# the robot to rest first, then ends all. --map: with MAP_keepout.yaml beside it, if it is there. --slam: makes the map while it drives. --emulate: emulators instead of devices, on a simulated floor.
# Exit status: 0 ended by Ctrl-C or by --for, 1 something is missing or failed, 2 wrong use. BANDWAGON_BRINGUP_SECONDS: longest wait (60).
# BANDWAGON_PROGRAM: another program than build/release/bin/bandwagon.
set -euo pipefail
umask 077 # logs hold the page's token

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=${BANDWAGON_PROGRAM:-$root/build/release/bin/bandwagon}
graph=$root/config/graphs/robot.yaml

refuse() { # refuse STATUS LINE...
  local status=$1
  shift
  printf '%s\n' "$@" >&2
  exit "$status"
}
usage="usage: $0 ROBOT.yaml [--map MAP.yaml | --slam] [--emulate] [--no-page] [options of bandwagon run]"

(($# > 0)) || refuse 2 "$usage" "Robots: $(cd "$root" && echo config/robots/*.yaml)"
robot=$1
shift
[[ $robot != -* ]] || refuse 2 "The robot file comes first, not '$robot'." "$usage"
[[ -f $robot ]] || refuse 2 "No such robot file: $robot" "There are: $(cd "$root" && echo config/robots/*.yaml)"

settings=(--set "robot=$(realpath "$robot")")
options=()
page=(--page)
emulated=false
slam=false
use_map() {
  [[ -f $1 ]] || refuse 2 "No such map: $1" "Wanted: the YAML file beside the picture, as map_server and map_saver have it."
  map=$(realpath "$1")
}
map=
while (($# > 0)); do
  case $1 in
    --map)
      (($# > 1)) || refuse 2 "--map needs a file" "$usage"
      use_map "$2"
      shift
      ;;
    --map=*) use_map "${1#--map=}" ;;
    --slam) slam=true ;;
    --emulate) emulated=true ;;
    --no-page) page=() ;;
    --page | --page=*) page=("$1") ;;
    --set)
      (($# > 1)) || refuse 2 "--set needs component.param=value" "$usage"
      settings+=(--set "$2")
      shift
      ;;
    --set=*) settings+=("$1") ;;
    *) options+=("$1") ;;
  esac
  shift
done
if $slam; then
  [[ -z $map ]] || refuse 2 "--slam makes the map, --map brings one: not both." "$usage"
  settings+=(--set slam.enabled=true --set explore.enabled=true --set localization.enabled=false --set map_server.enabled=false)
fi
[[ -z $map ]] || settings+=(--set "map_server.map=$map")
# Keep-out zones that somebody drew on the page are saved beside the map.
zones=${map%.yaml}_keepout.yaml
[[ -z $map || ! -f $zones ]] || settings+=(--set "keepout_filter_mask_server.map=$zones")
[[ -z $map ]] || ! $emulated || settings+=(--set "world.map=$map")
! $emulated || settings+=(--set emulate=true)

[[ -x $program ]] || refuse 1 "The program is not built. Build it first:" \
  "  $root/launch_scripts/setup.sh && $root/launch_scripts/build.sh release program"
"$program" graph "$graph" "${settings[@]}" --processes >/dev/null || exit 2

echo "Robot: $robot$($emulated && echo ' (emulated)')"
if ! "$program" doctor --graph "$graph" "${settings[@]}"; then
  refuse 1 "" "Not started: a port of the robot cannot be opened. What is plugged in: $program doctor --ports" \
    "Names that stay, and rights, by a udev rule that is installed by hand (its first lines say how):" \
    "  $root/config/udev/99-bandwagon.rules"
fi

logs=${BANDWAGON_LOG_DIR:-$root/run/robot-$(date +%Y%m%d-%H%M%S)}
stopped=false
stop() {
  $stopped && return
  stopped=true
  echo "Bringing the robot to rest ..."
  # It passes it on to each of its processes by id; they stop the robot before they end.
  kill -TERM "$processes" 2>/dev/null || true
}
"$program" launch "$graph" --logs "$logs" "${settings[@]}" --stay "${page[@]}" "${options[@]}" &
processes=$!
trap stop INT TERM HUP

finish() { # waits for all processes; a signal that comes meanwhile is passed on
  local status=0
  while kill -0 "$processes" 2>/dev/null; do
    status=0
    wait "$processes" || status=$?
  done
  return "$status"
}

# What is missing still, a line for each; nothing: all is up.
missing() {
  local manager state
  for manager in localization navigation; do
    "$program" service call "/lifecycle_manager_$manager/is_active" --timeout 3 2>/dev/null | grep -q 'success: true' ||
      echo "components that lifecycle_manager_$manager brings up are not active yet"
  done
  state=$("$program" topic echo /base_state --once --for 3 2>/dev/null) || true
  case $(awk '$1 == "state:" { print $2 }' <<<"$state") in
    '') echo "the base says nothing (/base_state)" ;;
    9 | 10) echo "the base: $(sed -n 's/^reason: //p' <<<"$state")" ;;
  esac
  [[ -n $("$program" topic echo /scan --once --for 3 2>/dev/null | head -n 1) ]] || echo "no scans (/scan): laser"
}

end=$((SECONDS + ${BANDWAGON_BRINGUP_SECONDS:-60}))
while :; do
  what=$(missing)
  if $stopped || ! kill -0 "$processes" 2>/dev/null; then break; fi
  [[ -n $what ]] || break
  if ((SECONDS >= end)); then
    printf 'Not up after %s s:\n%s\n' "${BANDWAGON_BRINGUP_SECONDS:-60}" "$what" >&2
    stop
    finish || true
    refuse 1 "Logs: $logs"
  fi
done

if ! $stopped && kill -0 "$processes" 2>/dev/null; then
  echo "Up: base, laser and all components."
  ! $slam || echo "The map grows while it drives: by hand, or by itself: $program explore"
  [[ -n $map ]] || $slam || $emulated || echo "There is no map: drive by hand; goals need --map MAP.yaml and a first pose."
  sed -n 's/^Page: /Page: /p' "$logs"/viewer.* 2>/dev/null | head -n 1 || true
  echo "Stop by Ctrl-C. By hand: $program teleop"
fi
status=0
finish || status=$?
$stopped && status=0
exit "$status"
