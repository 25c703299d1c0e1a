#!/usr/bin/env bash
# check_hazards.sh ROOT: the table of hazards in tests/README.md. Every row has six columns, numbers rise by one, and each has a test or says
# "open"; every test it names (`Suite.Test`) and every file exists, so that no row outlives what showed it.
set -euo pipefail
cd "$1"

table=$(awk '/^\| row \| hazard \|/ {inside = 1; next} inside && !/^\|/ {exit} inside && !/^\|-/' tests/README.md)
[[ -n $table ]] || { echo 'tests/README.md has no table of hazards'; exit 1; }
known=$(find tests -name '*.cpp' -exec cat {} + | tr '\n' ' ' |
  grep -oE '\bTEST(_F|_P)?\( *[A-Za-z0-9_]+ *, *[A-Za-z0-9_]+ *\)' |
  sed -E 's/TEST(_F|_P)?\( *([A-Za-z0-9_]+) *, *([A-Za-z0-9_]+) *\)/\2.\3/' | sort -u)

status=0
complain() { echo "tests/README.md, row $1: $2"; status=1; }

expected=0 names=0
while IFS='|' read -r _ row hazard barrier figure tests remains rest; do
  row=${row// /}
  expected=$((expected + 1))
  [[ $row == "$expected" ]] || complain "$row" "should be row $expected"
  [[ -z ${rest// /} && -n ${remains// /} ]] || complain "$row" 'has not six columns'
  for cell in "$hazard" "$barrier" "$figure"; do [[ -n ${cell// /} ]] || complain "$row" 'has an empty column'; done
  named=$(grep -oE '`[^`]+`' <<<"$tests" | tr -d '`' || true)
  [[ -n $named || $tests =~ (^|[^a-z])open([^a-z]|$) ]] || complain "$row" 'has no test and does not say "open"'
  while read -r name; do
    [[ -n $name ]] || continue
    names=$((names + 1))
    if [[ $name == */* ]]; then
      [[ -e $name ]] || complain "$row" "there is no file $name"
    else
      grep -qxF -- "$name" <<<"$known" || complain "$row" "there is no test $name"
    fi
  done <<<"$named"
done <<<"$table"
echo "$expected rows, $names tests and files looked at"
exit "$status"
