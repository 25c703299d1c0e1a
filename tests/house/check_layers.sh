#!/usr/bin/env bash
# check_layers.sh ROOT: which room may include which.
#
#   - runtime/ knows no robot: it includes nothing of components/.
#   - The ground floor, runtime/base/, includes nothing but itself.
#   - The runtime's core includes no recording (runtime/recording/), nothing that talks to people far away (runtime/remote/), no verb
#     (runtime/cli/).
#   - Components include neither the program nor the lab, and the program includes no lab.
#   - No circle: neither between files, nor between rooms. A room is a folder of runtime/, runtime/recording/, runtime/remote/, components/ or
#     components/lab/; what lies directly in one of these is a room too.
set -euo pipefail
cd "$1"

# Lines "FILE INCLUDED".
includes=$(find runtime components \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z |
  xargs -0 sed -nE '/^[ \t]*#[ \t]*include[ \t]*"(runtime|components)\//{s/^[^"]*"([^"]+)".*/\1/;F;p}' | paste -d ' ' - -)

broken=0
refuse() { # refuse WHY, with the offending lines on standard input
  local found
  found=$(cat)
  [ -z "$found" ] && return
  awk -v why="$1" '{ print $1 ": includes " $2 ": " why }' <<<"$found"
  broken=1
}
refuse 'the runtime knows no components' < <(awk '$1 ~ /^runtime\// && $2 ~ /^components\//' <<<"$includes")
refuse 'the ground floor stands on nothing' < <(awk '$1 ~ /^runtime\/base\// && $2 !~ /^runtime\/base\//' <<<"$includes")
refuse 'the core of the runtime knows no recordings, no page and no verbs' < <(
  awk '$1 ~ /^runtime\// && $1 !~ /^runtime\/(recording|remote|cli)\// && $2 ~ /^runtime\/(recording|remote|cli)\//' <<<"$includes")
refuse 'the program is made of components, they do not know it' < <(
  awk '$1 !~ /^components\/(program|lab)\// && $2 ~ /^components\/(program|lab)\//' <<<"$includes")
refuse 'no robot needs the lab' < <(
  awk '$1 !~ /^components\/lab\// && $2 ~ /^components\/lab\//' <<<"$includes")

# tsort names the members of a loop on standard error.
circle() { # circle WHAT, with pairs on standard input
  local loop
  loop=$(tsort 2>&1 >/dev/null || true)
  [ -z "$loop" ] && return
  echo "circle between $1:"
  sed 's/^tsort: //; s/^/  /' <<<"$loop"
  broken=1
}
circle files < <(awk '$1 != $2' <<<"$includes")
circle rooms < <(awk '
  function room(path, part, n) {
    n = split(path, part, "/")
    if (part[2] ~ /^(recording|remote|lab)$/) return n == 3 ? part[1] "/" part[2] : part[1] "/" part[2] "/" part[3]
    return n == 2 ? part[1] : part[1] "/" part[2]
  }
  { if (room($1) != room($2)) print room($1), room($2) }' <<<"$includes" | sort -u)

echo "$(wc -l <<<"$includes") includes between the project's files looked at"
exit $broken
