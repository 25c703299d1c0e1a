#!/usr/bin/env bash
# check_purity.sh ROOT COMPILE_COMMANDS TARGET...
#
# The rule: an algorithm is a function of its arguments. Its sources, its headers, and every file of this project that they reach,
# directly or through others, may include
#   - the C++ standard library, but not what waits, measures time, or opens files and streams (kept_out below);
#   - Eigen and Ceres, and zlib for its checksums;
#   - the ground floor (runtime/base) and other algorithms of components/.
# So no DDS, no message class, no YAML, no logging, no thread, no clock. What Eigen or Ceres include for themselves is their affair.
# Which files are reached is what the compiler says (-H), for the sources of the TARGETs (those of bw_algorithm) and for a source that
# includes every header. A folder says what is no algorithm: adaptor/, files/, messages/, program/ and lab/ (cmake/bandwagon.cmake).
set -euo pipefail
root=$1
commands=$2
shift 2

not_pure='^components/(.*/)?(adaptor|files|messages|program|lab)/'
kept_out='thread|stop_token|mutex|shared_mutex|condition_variable|future|semaphore|latch|barrier|atomic|execution|coroutine'
kept_out+='|chrono|ctime|fstream|iostream|filesystem|syncstream|csignal'

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# One compiler command for each source of the targets, preprocessing only.
for target in "$@"; do
  { grep '"command":' "$commands" || true; } | { grep "/$target\.dir/" || true; } |
    sed -E 's/^ *"command": "//; s/",?$//; s/ -include [^ ]*cmake_pch[^ ]*//; s/ -MD -MT [^ ]+ -MF [^ ]+//; s/ -o [^ ]+ -c / -E -H -o \/dev\/null -c /; s/ -c / /' \
      >"$scratch/of_target"
  [ -s "$scratch/of_target" ] || { echo "no sources of $target in $commands" >&2; exit 1; }
  cat "$scratch/of_target" >>"$scratch/commands"
done
any=$(sed -E '1!d; s/ [^ ]+\.c(pp|xx)$//' "$scratch/commands")
(cd "$root" && find components runtime/base -name '*.hpp') | { grep -Ev "$not_pure" || true; } |
  sed "s|.*|#include \"$root/&\"|" >"$scratch/headers.cpp"
echo "$any $scratch/headers.cpp" >>"$scratch/commands"

# Lines "FILE<tab>CHAIN": every file of the project that is reached, and how.
while read -r command; do
  start=${command##* }
  if ! bash -c "$command" 2>"$scratch/tree"; then
    grep -v '^\.' "$scratch/tree" >>"$scratch/refused"
  fi
  awk -v root="$root/" -v start="$start" '
    function short(path) { return substr(path, length(root) + 1) }
    # A unity source and the one of headers are no files of the project: what they include is where chains begin.
    BEGIN { if (index(start, root) == 1 && start !~ /\/Unity\//) { chain[0] = short(start); print chain[0] "\t" chain[0] } }
    /^\.+ / {
      depth = length($1)
      ours = index($2, root) == 1
      chain[depth] = chain[depth - 1] (ours ? (chain[depth - 1] == "" ? "" : " > ") short($2) : "")
      if (ours) print short($2) "\t" chain[depth]
    }' "$scratch/tree"
done <"$scratch/commands" | sort -u -t "$(printf '\t')" -k 1,1 >"$scratch/reached"

broken=0
if [ -s "$scratch/refused" ]; then
  cat "$scratch/refused"
  broken=1
fi
while IFS=$'\t' read -r file chain; do
  if [[ $file =~ $not_pure ]]; then
    echo "$chain: no algorithm stands in such a folder"
    broken=1
  fi
  while read -r line include; do
    case $include in
      '"components/'* | '"runtime/base/'*) continue ;;
      '<Eigen/'* | '<ceres/'* | '<zlib.h>') continue ;;
    esac
    [[ $include =~ ^\<[a-z_]+\>$ && ! $include =~ ^\<($kept_out)\>$ ]] && continue
    echo "$chain:$line: includes $include"
    broken=1
  done < <(sed -nE '/^[ \t]*#[ \t]*include/{=;s/^[ \t]*#[ \t]*include[ \t]*([<"][^>"]*[>"]).*/\1/p}' "$root/$file" | paste -d ' ' - -)
done <"$scratch/reached"

echo "$(wc -l <"$scratch/reached") files of $# algorithm targets looked at"
exit $broken
