#!/usr/bin/env bash
# bringup_slam_test.sh ROOT PROGRAM MAP_WALLS: section 7 of config/robots/README.md on an emulated Kobuki: it explores, a map is made, a keep-out zone drawn, both saved, and the
# robot finds itself in them.
# shellcheck source=tests/interop/bringup_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/bringup_common.sh"
map_walls=$3

mkdir "$folder/maps"
up --slam --set "slam.folder=$folder/maps" --set "keepout_filter_mask_saver.folder=$folder/maps"
answers exploration_complete explore
answers 'result: 0' service call /slam_toolbox/save_map '{name: {data: home}}'
answers 'success: true' service call /keepout_filter_mask_server/draw_polygon \
  '{polygon: {header: {frame_id: map}, polygon: {points: [{x: 1, y: 1}, {x: 2, y: 1}, {x: 2, y: 2}, {x: 1, y: 2}]}}, value: 100}'
answers 'result: true' service call /keepout_filter_mask_saver/save_map '{map_url: home_keepout}'
down
for file in home.yaml home.pgm home_keepout.yaml home_keepout.pgm; do [[ -s $folder/maps/$file ]] || fail "$file is not there"; done

# The emulated floor: 13 by 11 m with two boxes (`world` of config/graphs/robot.yaml). Its outline is 48 m, 960 cells, and the sides of the boxes that are seen another
# 60; a cell's centre is off a wall through it by up to 3.5 cm, so that 7.5 cm, and what rounding adds, is within a cell.
read -r cells share < <("$map_walls" "$folder/maps/home.yaml" 0.08 0,0,13,0 13,0,13,11 13,11,0,11 0,11,0,0 \
  8.5,8.2,9.5,8.2 9.5,8.2,9.5,8.8 9.5,8.8,8.5,8.8 8.5,8.8,8.5,8.2 8.2,1.4,8.8,1.4 8.8,1.4,8.8,2.6 8.8,2.6,8.2,2.6 8.2,2.6,8.2,1.4)
((cells >= 700)) || fail "$cells cells of walls only"
awk "BEGIN { exit !($share >= 95) }" || fail "$share % of $cells cells of walls are where walls are"

# The robot on that map, by the particle filter, where it stood first.
up --map "$folder/maps/home.yaml"
# 1 m by 1 m from (1, 1) on, and the 1 m by 1 m from (0, 0) on with which the mask began: cells of 0.05 m, and those that the outline touches.
answers 'width: 4[01]' topic echo /keepout_filter_mask --once
# A status a second of each process; the localization's begins with its state.
ok() { "$program" topic echo /diagnostics --for 2 >"$folder/answer" && grep -A3 'name: .*localization' "$folder/answer" | grep -q 'message: .*OK'; }
for ((i = 0; i < 10; i++)); do
  ! ok || break
done
((i < 10)) || fail "the localization does not say OK: $(grep -A3 localization "$folder/answer")"
down
echo "a map of $cells cells of walls, $share % of them within a cell, and the robot in it"
