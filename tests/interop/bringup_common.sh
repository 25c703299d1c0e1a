#!/usr/bin/env bash
# Sourced by the tests of bringup.sh with ROOT and PROGRAM as the first two arguments: a folder of one's own, a robot that comes up and goes down, what a command answers.
set -euo pipefail
root=$1
# shellcheck disable=SC2034  # the tests use it
bringup=$root/launch_scripts/bringup.sh
program=$2
export BANDWAGON_PROGRAM=$program
folder=$(mktemp -d)
running=
clean_up() {
  [[ -z $running ]] || kill -TERM "$running" 2>/dev/null || true
  [[ -z $running ]] || wait "$running" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
fail() {
  echo "FAILED: $1"
  [[ ! -s $folder/out ]] || tail -n 40 "$folder/out"
  exit 1
}
up() { # up OPTIONS...: an emulated Kobuki
  : >"$folder/out"
  BANDWAGON_LOG_DIR=$folder/logs "$bringup" "$root/config/robots/kobuki.yaml" --emulate --no-page "$@" >"$folder/out" 2>&1 &
  running=$!
  local i
  for ((i = 0; i < 600; i++)); do
    ! grep -qF 'Up: base, laser and all components.' "$folder/out" || return 0
    kill -0 "$running" 2>/dev/null || fail "ended before it was up: $*"
    read -rt 0.1 <> <(:) || true
  done
  fail "is not up: $*"
}
down() {
  kill -TERM "$running"
  local status=0
  wait "$running" || status=$?
  running=
  ((status == 0)) || fail "status $status after it was stopped"
}
answers() { # answers WORDS COMMAND...
  "$program" "${@:2}" >"$folder/answer" 2>&1 || fail "status $? of ${*:2}: $(cat "$folder/answer")"
  grep -q -- "$1" "$folder/answer" || fail "'${*:2}' does not say '$1': $(cat "$folder/answer")"
}
