#!/usr/bin/env bash
# Installs what is missing, builds the program, and drives through the hallway. Options go to `bandwagon run`, for example: demo.sh --seed 3
# With --stay it drives in real time and waits at the goal for others (the page, /goal_pose), until Ctrl-C.
# It serves the page, whose address it prints; --no-page does not, --page=PORT says where.
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
page=(--page --bags "$out")
options=()
for option in "$@"; do
  case $option in
    --no-page) page=() ;;
    --page | --page=*) page=("$option" --bags "$out") ;;
    --stay)
      clock=(--clock wall)
      pace="real time, until Ctrl-C"
      options+=("$option")
      ;;
    *) options+=("$option") ;;
  esac
done
echo "A robot crosses a hallway with six walkers and two people who stand ($pace):"
status=0
"$root/build/release/bin/bandwagon" run "$root/config/graphs/hallway.yaml" \
  "${clock[@]}" --seed 7 --progress --fail-on-contact \
  --json "$out/score_card.json" --svg "$out/drive.svg" --record "$out/drive.mcap" "${page[@]}" "${options[@]}" || status=$?
echo
echo "Score card: $out/score_card.json"
echo "Picture:    $out/drive.svg"
echo "On a page:  $root/build/release/bin/bandwagon view $out/drive.mcap"
echo "Recording:  $out/drive.mcap, to be driven again by any of its components:"
echo "  $root/build/release/bin/bandwagon replay $out/drive.mcap --graph $root/config/graphs/hallway.yaml --run local_planner"
exit "$status"
