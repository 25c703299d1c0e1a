#!/usr/bin/env bash
# leaderboard.sh FOLDER [PER_CENT [PLANNER...]]: all suites by all planners, a file each in FOLDER, and their page, FOLDER/index.html.
#
# What is there is not driven again, so that the same command goes on, and others add to it. PER_CENT of the drives (100). mppi_tuned is mppi with
# config/planners/mppi_tuned.txt, and so are others. FOLDER/cpu.txt: CPU of each file; how long all takes: components/lab/leaderboard/README.md.
# BANDWAGON_JOBS drives at a time (2). BANDWAGON_SHARED: worlds and recorded people; their suites are left out without.
set -euo pipefail

(($# >= 1)) || { sed -n '2s/^# //p' "$0" >&2 && exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
lab=$(realpath "${BANDWAGON_LAB:-$root/build/release/bin/bandwagon-lab}")
folder=$1 share=${2:-100}
planners=("${@:3}")
((${#planners[@]} > 0)) || planners=(eteb pteb teb_homotopy teb orca mppi mppi_tuned hrvo edwa dwa orca_holonomic social_force_holonomic)
data=${BANDWAGON_SHARED:-}/data
jobs=(--jobs "${BANDWAGON_JOBS:-2}")
mkdir -p "$folder" && cd "$folder"

part() { echo $((($1 * share + 99) / 100)); }
failed=0
make() { # make NAME COMMAND...: once; what was interrupted has another name
  local name=$1
  shift
  [[ ! -f $name.json ]] || return 0
  local TIMEFORMAT="$name %U + %S s"
  if { time "$lab" "$@" --json "$name.part" >"$name.log" 2>&1; } 2>>cpu.txt; then
    mv "$name.part" "$name.json"
  else
    failed=1
    echo "$name: $(tail -n 1 "$name.log")" >&2
  fi
}
all_suites() { # all_suites PLANNER
  local name=$1 planner=${1%_tuned} set=() many=100 most=100 scene suite
  [[ $name != *_tuned ]] || readarray -t set < <(sed 's/^/--set=/' "$root/config/planners/$name.txt")
  local graph_set=("${set[@]/#--set=/--set=local_planner.}")
  case $name in
    eteb | *_holonomic) most=500 ;;
    hrvo | edwa | dwa) many=40 most=40 ;;
  esac
  alone() { make "$1-$name" bench "${@:2}" --planner "$planner" "${set[@]}" "${jobs[@]}"; }
  whole() { make "$1-$name" evaluate "${@:2}" --planners "$planner" "${graph_set[@]}" --html "pages/$name" "${jobs[@]}"; }
  whole_graphs() { # by their own senses
    whole hallway "$root/config/suites/hallway.yaml" --seeds "1..$(part 50)"
    [[ ! -d $data/barn_worlds ]] || make "barn-$name" bench course --graph "$root/config/graphs/course.yaml" --worlds "$data/barn_worlds" --generate "$(part 90)" --first-seed 2001 --planner "$planner" "${graph_set[@]}"
    if [[ -d $data/eth_ucy_pedestrians ]]; then
      local delays=(0.6 0.8 1.0 1.2 1.4) IFS=,
      delays=("${delays[@]:0:$(part 5)}")
      for suite in eth hotel zara01; do whole $suite "$root/config/suites/$suite.yaml" --variants own --vary "navigator.goal.delay=${delays[*]}"; done
    fi
  }

  for scene in crowd mixed_crowd; do alone "crowdnav_$scene" crowdnav --scene $scene --cases "$(part $most)"; done
  for scene in circle square; do alone "crowdnav_$scene" crowdnav --scene $scene --cases "$(part $many)"; done
  [[ $name != *_holonomic ]] || return 0  # CrowdNav's own
  alone corridor corridor --drives "$(part $most)"
  alone crowd crowd --generate "$(part $many)" --first-seed 50001
  alone crossing corridor --walkers crossing --drives "$(part $many)"
  [[ ! -d $data/dynabarn ]] || alone dynabarn dynabarn --worlds "$data/dynabarn" --phases "$(part $((many / 10)))"
  case $name in eteb | pteb | mppi*) whole_graphs ;; esac
  alone flows flows --drives "$(part $many)"
}

for name in "${planners[@]}"; do all_suites "$name"; done
files=()
for file in *-*.json; do files+=("$([[ $file != *_tuned.json ]] || echo tuned:)$file"); done
"$lab" leaderboard "${files[@]}" -o index.html --json leaderboard.json
exit $failed
