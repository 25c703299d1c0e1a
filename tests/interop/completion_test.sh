#!/usr/bin/env bash
# completion_test.sh BANDWAGON COMPLETION: what bash offers for lines that somebody has begun, by the completion that is installed and the
# program itself. Expected: verbs by --help, files by `bandwagon graphs|robots`, planners by the README.
set -euo pipefail

program=$1
# shellcheck source=/dev/null
. "$2"
failed=0
offers() { # offers LINE WORD...: exactly these, in any order
  local line=$1 expected got
  shift
  COMP_LINE=$line COMP_POINT=${#line} COMPREPLY=()
  _bandwagon "$program" 2>/dev/null || true # compopt works in a real completion alone
  expected=$(printf '%s\n' "$@" | sort)
  got=$(printf '%s\n' "${COMPREPLY[@]}" | sort)
  [[ $got == "$expected" ]] && return
  printf '%s<TAB>\n expected: %s\n      got: %s\n' "$line" "${expected//$'\n'/ }" "${got//$'\n'/ }"
  failed=1
}
export XDG_CONFIG_HOME=/nowhere

offers "bandwagon re" record replay reproduce
offers "bandwagon bag co" convert
offers "bandwagon ma" map
offers "bandwagon map --ov" --overwrite
offers "bandwagon bench re" relations
offers "bandwagon run hall" hallway
offers "bandwagon run hallway --clo" --clock
offers "bandwagon run hallway --clock " lockstep topic wall
# Bash replaces what is behind the = alone.
offers "bandwagon run robot --set robot=ko" kobuki
offers "bandwagon run hallway --set local_planner.algorithm=te" teb teb_homotopy
offers "bandwagon run hallway --set local_planner.alg" local_planner.algorithm=
offers "bandwagon run hallway --set world.people_react=" false true
offers "bandwagon run hallway --seed 7 --set robot=ed" eddie
offers "bandwagon param list two" two_robots
offers "bandwagon enable jack" jackal
offers "bandwagon evaluate small" small_house
offers "bandwagon evaluate hallway --planners teb,pt" teb,pteb
# Files are bash's own.
offers "bandwagon run no_such_" ""
offers "bandwagon bag info x" ""
exit "$failed"
