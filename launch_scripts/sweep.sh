#!/usr/bin/env bash
# sweep.sh HOST,HOST OUT.json SHARDS SUITE... [options of evaluate]: an evaluation on hosts by ssh (GNU parallel), merged into OUT.json.
#
# N/HOST: N shards at a time there, as many as it has cores without. Every host has the program (packages, or BANDWAGON: its path) and sees the
# folder of OUT.json and the suites under the same names. A shard that fails is tried on other hosts; after anything else the same command
# goes on with the shards that are not complete. On one machine: evaluate --jobs N.
set -euo pipefail

(($# >= 4)) || { sed -n '2s/^# //p' "$0" >&2 && exit 2; }
command -v parallel >/dev/null || { echo "parallel is not here: apt install parallel" >&2 && exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=launch_scripts/shards.sh
. "$root/shards.sh"
hosts=$1
shift
begin_sweep "$@"

if ((${#left[@]} > 0)); then
  # A shard gives its cores back when ssh ends: of a host that is lost, too.
  parallel --will-cite -S "$hosts" --retries 3 --joblog "$shards/hosts.log" \
    "cd $(printf %q "$PWD") && $command --shard={}/$count --json=$(printf %q "$shards")/{}.json >$(printf %q "$shards")/{}.log 2>&1" ::: "${left[@]}" || true
fi
end_sweep
