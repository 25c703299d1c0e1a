#!/usr/bin/env bash
# bringup_slam_test.sh ROOT PROGRAM MAP_WALLS: section 7 of config/robots/README.md on an emulated Kobuki: it makes a map by itself, the map is saved, and the robot finds itself in it.
set -euo pipefail
root=$1
bringup=$root/launch_scripts/bringup.sh
program=$2
map_walls=$3
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
up() { # up OPTIONS...
  : >"$folder/out"
  BANDWAGON_LOG_DIR=$folder/logs "$bringup" "$root/config/robots/kobuki.yaml" --emulate --no-page "$@" >"$folder/out" 2>&1 &
  running=$!
  local i
  for ((i = 0; i < 600; i++)); do
    ! grep -qF 'Up: base, laser and all components.' "$folder/out" || return 0
    kill -0 "$running" 2>/dev/null || fail "ended before it was up: $*"
    read -rt 0.1 <> <(:) || true
  done
  fail "is not up: $*"
}
down() {
  kill -TERM "$running"
  local status=0
  wait "$running" || status=$?
  running=
  ((status == 0)) || fail "status $status after it was stopped"
}
answers() { # answers WORDS COMMAND...
  "$program" "${@:2}" >"$folder/answer" 2>&1 || fail "status $? of ${*:2}: $(cat "$folder/answer")"
  grep -q -- "$1" "$folder/answer" || fail "'${*:2}' does not say '$1': $(cat "$folder/answer")"
}
drive_to() { # drive_to X Y
  answers SUCCEEDED action send_goal /navigate_to_pose nav2_msgs/action/NavigateToPose \
    "{pose: {header: {frame_id: map}, pose: {position: {x: $1, y: $2}, orientation: {w: 1.0}}}}"
}

mkdir "$folder/maps"
up --slam --set "slam.folder=$folder/maps"
answers exploration_complete explore
drive_to 6.0 5.0
answers 'result: 0' service call /slam_toolbox/save_map '{name: {data: home}}'
down
for file in home.yaml home.pgm; do [[ -s $folder/maps/$file ]] || fail "$file is not there"; done

# The emulated floor: 13 by 11 m with two boxes (`world` of config/graphs/robot.yaml). Its outline is 48 m, 960 cells, and the sides of the boxes that are seen another
# 60. Walls lie on lines between cells, so that centres are off by 2.5 cm on either side and by 7.5 cm one cell farther: within a cell, and 1 mm for rounding.
read -r cells share < <("$map_walls" "$folder/maps/home.yaml" 0.076 0,0,13,0 13,0,13,11 13,11,0,11 0,11,0,0 \
  8.5,8.2,9.5,8.2 9.5,8.2,9.5,8.8 9.5,8.8,8.5,8.8 8.5,8.8,8.5,8.2 8.2,1.4,8.8,1.4 8.8,1.4,8.8,2.6 8.8,2.6,8.2,2.6 8.2,2.6,8.2,1.4)
((cells >= 700)) || fail "$cells cells of walls only"
awk "BEGIN { exit !($share >= 95) }" || fail "$share % of $cells cells of walls are where walls are"

# The robot on that map, by the particle filter, where it stood first.
up --map "$folder/maps/home.yaml"
# A status a second of each process; the localization's begins with its state.
ok() { "$program" topic echo /diagnostics --for 2 >"$folder/answer" && grep -A3 'name: .*localization' "$folder/answer" | grep -q 'message: .*OK'; }
for ((i = 0; i < 10; i++)); do
  ! ok || break
done
((i < 10)) || fail "the localization does not say OK: $(grep -A3 localization "$folder/answer")"
down
echo "a map of $cells cells of walls, $share % of them within a cell, and the robot in it"
