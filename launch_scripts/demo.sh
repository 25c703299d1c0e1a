#!/usr/bin/env bash
# Installs what is missing, builds the program, and drives through the hallway. Options go to `bandwagon run`, for example: demo.sh --seed 3
# With --stay it drives in real time and waits at the goal for others (/goal_pose), until Ctrl-C.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/launch_scripts/setup.sh"
"$root/launch_scripts/build.sh" release program

out=$root/run/demo
mkdir -p "$out"
rm -f "$out/drive.mcap"
echo
clock=(--clock lockstep --pace "${BANDWAGON_PACE:-4}")
pace="4 times real time"
for option in "$@"; do
  if [[ $option == --stay ]]; then
    clock=(--clock wall)
    pace="real time, until Ctrl-C"
  fi
done
echo "A robot crosses a hallway with six walkers and two people who stand ($pace):"
status=0
"$root/build/release/bin/bandwagon" run "$root/config/graphs/hallway.yaml" \
  "${clock[@]}" --seed 7 --progress --fail-on-contact \
  --json "$out/score_card.json" --svg "$out/drive.svg" --record "$out/drive.mcap" "$@" || status=$?
echo
echo "Score card: $out/score_card.json"
echo "Picture:    $out/drive.svg"
echo "Recording:  $out/drive.mcap, to be driven again by any of its components:"
echo "  $root/build/release/bin/bandwagon replay $out/drive.mcap --graph $root/config/graphs/hallway.yaml --run local_planner"
exit "$status"
