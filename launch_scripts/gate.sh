#!/usr/bin/env bash
# gate.sh [--write|--short]: did planners get worse? The same drives as in tests/changes/gate.json, by eteb, pteb and teb; status 1 where
# McNemar's test says so (p < .01). Twelve minutes on two cores; --short: a part of them, in three. --write: what is there now is right.
# BANDWAGON_SHARED: DynaBARN's worlds, left out without it.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
lab=${BANDWAGON_LAB:-$root/build/release/bin/bandwagon-lab}
what=${1:-}
[[ -z $what || $what == --write || $what == --short ]] || { sed -n '2s/^# //p' "$0" >&2 && exit 2; }
[[ -n ${BANDWAGON_LAB:-} ]] || "$root/launch_scripts/build.sh" release lab
planners=eteb,pteb,teb
part() { if [[ $what == --short ]]; then echo "$1"; else echo "$2"; fi; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
jobs=${BANDWAGON_JOBS:-2}

bench() { # bench FILE ARGUMENTS...
  local file=$work/$1.json
  shift
  "$lab" bench "$@" --planner $planners --jobs "$jobs" --json "$file" >/dev/null
}
bench crowd crowd --generate "$(part 30 150)"
bench crowdnav crowdnav --scene crowd --cases "$(part 15 60)"
bench square crowdnav --scene square --cases "$(part 40 200)"
bench flows flows --scene "$(part G1,G4,G5a F3,G)" --drives "$(part 10 40)"
bench corridor corridor --people 12 --drives "$(part 40 150)"
[[ ! -d ${BANDWAGON_SHARED:-}/data/dynabarn ]] || bench dynabarn dynabarn --worlds "$BANDWAGON_SHARED/data/dynabarn" --phases "$(part 1 4)"
"$lab" evaluate "$root/config/suites/hallway.yaml" --planners $planners --seeds 1.."$(part 2 6)" --jobs "$jobs" --json "$work/hallway.json" >/dev/null 2>&1

gate=$root/tests/changes/gate.json
if [[ $what == --write ]]; then
  "$lab" leaderboard "$work"/*.json --write-gate "$gate"
else
  "$lab" leaderboard "$work"/*.json --gate "$gate"
fi
