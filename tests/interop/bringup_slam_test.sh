#!/usr/bin/env bash
# bringup_slam_test.sh ROOT PROGRAM MAP_WALLS: section 7 of config/robots/README.md on an emulated Kobuki: it explores, a map is made, saved, and the robot finds itself in it.
# shellcheck source=tests/interop/bringup_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/bringup_common.sh"
map_walls=$3

mkdir "$folder/maps"
up --slam --set "slam.folder=$folder/maps"
answers exploration_complete explore
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
