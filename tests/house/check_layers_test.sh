#!/usr/bin/env bash
# check_layers.sh refuses each kind of broken wall, and names it.
set -euo pipefail
check=$(dirname "${BASH_SOURCE[0]}")/check_layers.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT

file() { # file PATH INCLUDED...
  mkdir -p "$house/$(dirname "$1")"
  printf '#include "%s"\n' "${@:2}" >"$house/$1"
}
expect() { # expect TEXT: the check fails and says TEXT
  local said status=0
  said=$("$check" "$house") || status=$?
  if ((status == 0)) || ! grep -qF "$1" <<<"$said"; then
    printf 'expected a failure with "%s", got exit status %d and:\n%s\n' "$1" "$status" "$said" >&2
    exit 1
  fi
  rm -rf "${house:?}"/*
  sound
}
sound() {
  file runtime/host/host.hpp runtime/base/time.hpp
  file components/a/a.hpp components/model/pose.hpp runtime/base/time.hpp
  file runtime/recording/bag/bag.cpp runtime/host/host.hpp
  file components/program/run.cpp components/a/a.hpp
  file components/lab/bench/bench.cpp components/program/run.hpp
}

sound
"$check" "$house" >/dev/null
file runtime/host/host.cpp components/model/pose.hpp
expect 'runtime/host/host.cpp: includes components/model/pose.hpp'
file runtime/base/time.hpp runtime/host/host.hpp
expect 'the ground floor stands on nothing'
file runtime/host/host.cpp runtime/recording/bag/bag.hpp
expect 'the core of the runtime knows no recordings'
file components/b/b.hpp components/program/run.hpp
expect 'they do not know it'
file components/program/run.cpp components/lab/bench/bench.hpp
expect 'no robot needs the lab'
file runtime/recording/bag/a.hpp runtime/recording/replay/a.hpp
file runtime/recording/replay/b.hpp runtime/recording/bag/b.hpp
expect 'circle between rooms'
file components/b/b.hpp components/b/c.hpp
file components/b/c.hpp components/b/b.hpp
expect 'circle between files'
file components/b/b.hpp components/a/a.hpp
file components/a/other.hpp components/b/other.hpp
expect 'circle between rooms'
