#!/usr/bin/env bash
# robot_page.sh PROGRAM README: every command in the page's fenced blocks is one that would be taken: scripts and files are there, verbs and options
# are known to the program. What is run for real: bringup_test.sh.
set -euo pipefail
program=$1
page=$2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
broken=0
complain() {
  echo "$1"
  broken=1
}

check_program() { # the words behind `bandwagon`
  local verb=() word help
  for word in "$@"; do
    [[ $word == -* || $word == /* || $word == *.* ]] && break
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
done < <(awk '/^```/ { inside = !inside; next } inside' "$page"; grep -oP '\x60bandwagon [^\x60]*' "$page" | tr -d '\140')
echo "$count commands of $page looked at"
((count >= 15)) || complain "fewer than 15: is this the page?"
exit "$broken"
