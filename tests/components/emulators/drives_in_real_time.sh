#!/usr/bin/env bash
# drives_in_real_time.sh ROOT PROGRAM [COUNT [ROBOT...]]: the light hallway in real time, every byte over a pseudo-terminal, COUNT drives (1) of each
# robot in one process and COUNT in three; 40 s each, one after another. Robots: kobuki qbot2e eddie. Prints every score card with the
# machine's load before it. Status 0 when all reach their goal without a contact.
set -euo pipefail
root=$(cd "$1" && pwd)
program=$(realpath "$2")
count=${3:-1}
robots=("${@:4}")
((${#robots[@]})) || robots=(kobuki qbot2e eddie)
scratch=$(mktemp -d)
export XDG_STATE_HOME=$scratch/state
trap 'rm -rf "$scratch"' EXIT
graph=$root/config/graphs/hallway.yaml
light="$(sed -n '/name: light/,$p' "$root/config/suites/hallway.yaml" | tr -d '\n' | sed 's/.*"\(.*\)".*/\1/')"

value() { sed -n "s/^  \"$1\": \(.*[^,]\),\{0,1\}$/\1/p" "$2"; }

drive() { # PROCESSES ROBOT SEED
  local options=(--clock wall --seed "$3" --set robot="$root/config/robots/$2.yaml" --emulate --set "$light" --for 120)
  rm -rf "${scratch:?}/drive"
  if (($1 == 1)); then
    mkdir "$scratch/drive"
    "$program" run "$graph" "${options[@]}" --json "$scratch/drive/rest.json" >"$scratch/log" 2>&1 || true
  else
    "$program" launch "$graph" --logs "$scratch/drive" "${options[@]}" >"$scratch/log" 2>&1 || true
  fi
  [ -s "$scratch/drive/rest.json" ] || { cat "$scratch/log" >&2; exit 1; }
}

good=0 all=0
echo "robot    processes seed   load time [s] near [m] contacts"
for ((seed = 1; seed <= count; seed++)); do
  for robot in "${robots[@]}"; do
    for processes in 1 3; do
      load=$(cut -d' ' -f1 /proc/loadavg)
      drive "$processes" "$robot" "$seed"
      card=$scratch/drive/rest.json
      verdict="$(value collisions "$card")"
      ((all += 1))
      if [ "$(value reached "$card")" = true ] && [ "$verdict" = 0 ]; then ((good += 1)); else verdict+=" FAILED: $(value reason "$card")"; fi
      printf '%-8s %9d %4d %6.2f %8.1f %8.2f %s\n' "$robot" "$processes" "$seed" "$load" "$(value time_to_goal_s "$card")" \
        "$(value min_distance_m "$card")" "$verdict"
    done
  done
done
echo "$good of $all reached the goal without a contact"
((good == all))
