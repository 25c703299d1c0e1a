#!/usr/bin/env bash
# benchmark.sh --against COMMIT [NAME...]: did it get slower? Builds both trees and runs their benchmarks by turns.
#
# A row for each: CPU time of this tree over that of the other, median and range of the turns, "slower" or "faster" where all turns say so by more than 3 %.
# NAME: only benchmarks whose program has it in its name, as ekf; `hallway` and `teb` are a whole drive and open-loop bands. --turns N (7).
# --builds OLD NEW in place of --against COMMIT: two build folders that are there. On a quiet machine.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
usage() { sed -n '2s/^# //p' "$0" >&2 && exit 2; }
turns=7 commit='' old='' new=$root/build/release names=()
while (($# > 0)); do
  case $1 in
    --against) commit=${2:?} && shift 2 ;;
    --builds) old=${2:?} new=${3:?} && shift 3 ;;
    --turns) turns=${2:?} && shift 2 ;;
    -*) usage ;;
    *) names+=("$1") && shift ;;
  esac
done
[[ -n $commit || -n $old ]] || usage
if [[ -n $commit ]]; then
  revision=$(git -C "$root" rev-parse --verify "$commit^{commit}")
  tree=${XDG_CACHE_HOME:-$HOME/.cache}/bandwagon/benchmark/$revision
  [[ -d $tree ]] || git -C "$root" worktree add --detach "$tree" "$revision" >&2
  "$tree/launch_scripts/build.sh" release tests >&2
  "$root/launch_scripts/build.sh" release tests >&2
  old=$tree/build/release
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

wanted() {
  ((${#names[@]} == 0)) && return
  local name
  for name in "${names[@]}"; do [[ $1 != *$name* ]] || return 0; done
  return 1
}
cpu_of() { # cpu_of COMMAND...: user and system time of it [s]
  local TIMEFORMAT='%U %S'
  { time "$@" >/dev/null 2>&1; } 2>&1 | awk 'NF == 2 {print $1 + $2}'
}
# "name value" for each figure, once.
run() { # run BUILD PROGRAM
  local build=$1 program=$2
  case $program in
    hallway) echo "hallway $(cpu_of "$build/bin/bandwagon" run hallway --clock lockstep --seed 1)" ;;
    teb) echo "teb $(cpu_of "$build/bin/bandwagon-lab" bench crowd --generate 6 --first-seed 1 --planner eteb)" ;;
    *) "$build/bin/$program" --benchmark_format=json 2>/dev/null | awk -F'"' '
      $2 == "name" {name = $4; gsub(/ /, "_", name)}
      $2 == "run_type" {single = $4 == "iteration"}
      $2 == "cpu_time" && single {value = $3; gsub(/[:, ]/, "", value); if (value + 0 > 0) print program "/" name, value}' program="$program" ;;
  esac
}

programs=()
for path in "$new"/bin/benchmark_*; do [[ ! -x $path ]] || programs+=("$(basename "$path")"); done
programs+=(hallway teb)
for program in "${programs[@]}"; do
  wanted "$program" || continue
  [[ $program != benchmark_* || -x $old/bin/$program ]] || { echo "$program: not in the other tree" && continue; }
  : >"$work/ratios"
  for ((turn = 0; turn < turns; ++turn)); do
    # Who goes first changes: the machine's clock rises and falls.
    if ((turn % 2 == 0)); then run "$old" "$program" >"$work/old" && run "$new" "$program" >"$work/new"; else run "$new" "$program" >"$work/new" && run "$old" "$program" >"$work/old"; fi
    awk 'NR == FNR {before[$1] = $2; next} $1 in before && before[$1] > 0 {print $1, $2 / before[$1]}' "$work/old" "$work/new" >>"$work/ratios"
  done
  sort -k1,1 -k2,2g "$work/ratios" | awk '
    function tell() {
      if (n == 0) return
      middle = n % 2 ? r[(n + 1) / 2] : (r[n / 2] + r[n / 2 + 1]) / 2
      word = r[1] > 1.03 ? "  slower" : r[n] < 0.97 ? "  faster" : ""  # a > in a print would be a file to some
      printf "%-60s %.3f (%.3f to %.3f)%s\n", name, middle, r[1], r[n], word
    }
    $1 != name {tell(); name = $1; n = 0}
    {r[++n] = $2}
    END {tell()}'
done
