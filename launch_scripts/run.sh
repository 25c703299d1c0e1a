#!/usr/bin/env bash
# Runs a graph in one process: run.sh GRAPH [options of `bandwagon run`]. Builds first if that was not done yet.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/build/release/bin/bandwagon
if (($# == 0)); then
  echo "usage: $0 GRAPH [options of bandwagon run]" >&2
  exit 2
fi
if [[ ! -x $program ]]; then
  "$root/launch_scripts/setup.sh"
  "$root/launch_scripts/build.sh" release program
fi
exec "$program" run "$@"
