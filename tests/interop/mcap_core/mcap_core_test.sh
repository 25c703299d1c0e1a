#!/usr/bin/env bash
# mcap_core_test.sh PROGRAM BAG_LEAVES MODULES GRAPH: Foxglove's readers and decoders read our recordings whole, and every value of every
# message as we read it. Ends with 77, skipped, where Node.js or the packages are missing (launch_scripts/setup.sh tests).
set -euo pipefail
program=$1
leaves=$2
modules=$3
graph=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if ! command -v node >/dev/null || [[ ! -d $modules/node_modules/@foxglove/crc ]]; then
  echo "skipped: Node.js or the packages in $modules are missing; launch_scripts/setup.sh tests installs them"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Three seconds do not reach the goal: exit status 1.
status=0
"$program" run "$graph" --clock lockstep --for 3 --record "$work/drive" >"$work/said" 2>&1 || status=$?
if ((status > 1)); then
  cat "$work/said" >&2
  exit 1
fi
"$program" bag convert "$work/drive" "$work/lz4.mcap" --compression lz4
"$program" bag convert "$work/drive" "$work/none.mcap" --compression none
for compression in zstd lz4 none; do "$leaves" make "$work/types_$compression.mcap" "${compression/none/}"; done

node "$here/read_bags.mjs" "$modules" "$leaves" \
  "drive, a folder=zstd=$work/drive" "drive, lz4=lz4=$work/lz4.mcap" "drive, uncompressed==$work/none.mcap" \
  "every type, zstd=zstd=$work/types_zstd.mcap" "every type, lz4=lz4=$work/types_lz4.mcap" "every type, uncompressed==$work/types_none.mcap"
