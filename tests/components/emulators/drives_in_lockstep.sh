#!/usr/bin/env bash
# drives_in_lockstep.sh ROOT PROGRAM [SEED...]: the hallway in lock-step through the emulated bases and laser, with the drivers of real ones. For
# each robot: the goal without any contact; the same bytes twice; and a replay of the base's driver on the record gives the same bytes.
# Prints score cards beside those of the same robots without a cable.
set -euo pipefail
root=$1
program=$2
shift 2
seeds=("${@:-7}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

value() { sed -n "s/^  \"$1\": \(.*[^,]\),\{0,1\}$/\1/p" "$2"; }

drive() { # NAME ROBOT SEED OPTIONS...
  local name=$1 robot=$2 seed=$3
  shift 3
  "$program" run "$root/config/graphs/hallway.yaml" --clock lockstep --seed "$seed" --set robot="$root/config/robots/$robot.yaml" \
    --json "$scratch/$name.json" "$@" >"$scratch/$name.log" 2>&1 || true
  [ -s "$scratch/$name.json" ] || { cat "$scratch/$name.log" >&2; exit 1; }
}

row() {
  local card=$scratch/$1.json
  printf '%-22s %8.1f %8.2f %8.2f %8.2f %5s\n' "$1" "$(value time_to_goal_s "$card")" "$(value path_length_m "$card")" \
    "$(value min_distance_m "$card")" "$(value rms_jerk_mps3 "$card")" "$(value collisions "$card")"
}

worst=0
fail() {
  echo "$1" >&2
  worst=1
}

echo "robot                  time [s]  way [m] near [m] jerk [m/s3] contacts"
for seed in "${seeds[@]}"; do
  for robot in kobuki eddie; do
    plain=$robot-$seed-simulated emulated=$robot-$seed-emulated again=$robot-$seed-again
    drive "$plain" "$robot" "$seed" --set robot.base.driver=simulated --set robot.laser.driver=none
    drive "$emulated" "$robot" "$seed" --emulate --record "$scratch/$emulated"
    drive "$again" "$robot" "$seed" --emulate
    row "$plain"
    row "$emulated"
    card=$scratch/$emulated.json
    [ "$(value reached "$card")" = true ] || fail "$emulated: $(value reason "$card")"
    [ "$(value collisions "$card")" = 0 ] || fail "$emulated: $(value collisions "$card") contacts"
    [ "$(value samples_sha256 "$card")" = "$(value samples_sha256 "$scratch/$again.json")" ] ||
      fail "$emulated: two runs differ"
    "$program" replay "$scratch/$emulated" --graph "$root/config/graphs/hallway.yaml" --set robot="$root/config/robots/$robot.yaml" \
      --set emulate=true --run robot_base >"$scratch/replay.log" 2>&1 || { cat "$scratch/replay.log" >&2; fail "$emulated: replay differs"; }
    rm -rf "${scratch:?}/$emulated"
  done
done
exit "$worst"
