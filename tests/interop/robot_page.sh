#!/usr/bin/env bash
# robot_page.sh PROGRAM README LEAST [HEADING]: every command in the page's fenced blocks, or in those of its section HEADING, and every one that begins
# with the program or a script in the text is one that would be taken: scripts and files are there, verbs and options are known to the program. LEAST commands
# are expected. What is run for real: bringup_test.sh.
set -euo pipefail
program=$1
page=$2
least=$3
heading=${4:-}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
broken=0
complain() {
  echo "$1"
  broken=1
}

text=$(mktemp)
trap 'rm -f "$text"' EXIT
awk -v heading="$heading" 'heading == "" || $0 == heading { inside = 1 } /^## / && $0 != heading && heading != "" { inside = 0 } inside' "$page" >"$text"

check_program() { # the words behind `bandwagon`
  local verb=() word help
  for word in "$@"; do
    [[ $word == -* || $word == /* || $word == *.* || -f config/graphs/$word.yaml || -f config/robots/$word.yaml ]] && break  # graphs and robots go by their names
    verb+=("$word")
  done
  if ! help=$("$program" "${verb[@]}" --help 2>&1); then
    complain "bandwagon ${verb[*]}: no such verb"
    return
  fi
  # A parent's help at an unknown sub-verb would look like success.
  [[ $(head -n 3 <<<"$help") == *"bandwagon ${verb[*]}"* ]] || complain "bandwagon ${verb[*]}: no such verb"
  for word in "$@"; do
    [[ $word != -* ]] || grep -qE -- "(^|[ ,])${word%%=*}([ ,:{]|$)" <<<"$help" || complain "bandwagon ${verb[*]}: no option $word"
    [[ $word != config/* ]] || [[ -f $word ]] || complain "bandwagon ${verb[*]}: no file $word"
  done
}

check_script() { # SCRIPT ARGUMENTS
  [[ -x $1 ]] || complain "$1: no such script"
  local word
  for word in "${@:2}"; do
    [[ $word != config/* ]] || [[ -f $word ]] || complain "$1: no file $word"
    [[ $word != --* ]] || grep -q -- "$word" "$1" || complain "$1: no option $word"
  done
}

count=0
while read -r line; do
  line=${line%%#*}
  read -ra words <<<"$line"
  ((${#words[@]} > 0)) || continue
  count=$((count + 1))
  case ${words[0]} in
    bandwagon) check_program "${words[@]:1}" ;;
    launch_scripts/*) check_script "${words[@]}" ;;
    sudo) [[ ${words[1]} != cp ]] || [[ -f ${words[2]} ]] || complain "no file ${words[2]}" ;;
    *) complain "a command of nobody's: $line" ;;
  esac
done < <(awk '/^```/ { inside = !inside; next } inside' "$text"; grep -oP '\x60(bandwagon|launch_scripts/[a-z_]+\.sh) [^\x60]*' "$text" | tr -d '\140')
echo "$count commands of $page looked at"
((count >= least)) || complain "fewer than $least: is this the page?"
exit "$broken"
