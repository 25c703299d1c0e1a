#!/usr/bin/env bash
# check_names.sh BANDWAGON MOST: no more than MOST names can be turned, over all graphs and the drivers that these do not name.
set -euo pipefail

program=$1 most=$2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
count=$("$program" param list --all --count "$root"/config/graphs/*.yaml "$root"/config/graphs/nav2/*.yaml "$root"/tests/house/devices.yaml)
echo "$count"
names=$(tail -n 1 <<<"$count")
if ((names > most)); then
  echo "$names names of parameters, $((names - most)) too many: what nobody would set is a constant, or a field that code sets" >&2
  exit 1
fi
