#!/usr/bin/env bash
# A drive through the hallway in real time, recorded onto a disk that is full long before its end (row 22): full_disk.sh
#
# The robot must reach its goal; /diagnostics and the last lines must say that the recording ended, and why; what fitted must be
# read. The disk is a tmpfs of 2 MB in a mount namespace of this script's own, which takes root or a kernel that gives users such
# namespaces: exit status 77 where neither is there.
# BANDWAGON: the program, if it is not build/release/bin/bandwagon.
set -euo pipefail

if [[ ${1:-} != inside ]]; then
  unshare --map-root-user --mount true 2>/dev/null || { echo "skipped: no mount namespaces for this user"; exit 77; }
  exec unshare --map-root-user --mount "$0" inside
fi

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${BANDWAGON:-$root/build/release/bin/bandwagon}
folder=$(mktemp -d)
trap 'umount "$folder/disk" 2>/dev/null || true; rm -rf "$folder"' EXIT
mkdir "$folder/disk"
mount -t tmpfs -o size=2m tmpfs "$folder/disk" || { echo "skipped: tmpfs cannot be mounted here"; exit 77; }

"$program" run "$root/config/graphs/hallway.yaml" --seed 7 --json "$folder/card.json" --compression none \
  --record "$folder/disk/drive" >"$folder/out" 2>"$folder/log" &
robot=$!
# `topic echo` ends with the robot's process at the latest.
timeout 120 "$program" topic echo /diagnostics >"$folder/diagnostics" 2>/dev/null &
listener=$!
status=0
wait "$robot" || status=$?
kill "$listener" 2>/dev/null || true
wait "$listener" 2>/dev/null || true

head -1 "$folder/out"
grep -m 1 "ended early" "$folder/log" || true
failed=0
check() { # check WHAT COMMAND...
  local what=$1
  shift
  if "$@"; then echo "ok: $what"; else echo "FAILED: $what"; failed=1; fi
}
check "the robot reached its goal (exit status $status)" test "$status" = 0
check "the log says why the recording ended" grep -q "the recording ended early: .*No space left on device" "$folder/log"
check "so does the last line" bash -c "tail -1 '$folder/log' | grep -q 'the recording ended early: .*No space left on device'"
check "so does /diagnostics" grep -q "the recording ended early: .*No space left on device" "$folder/diagnostics"
"$program" bag info "$folder/disk/drive" >"$folder/info" 2>&1 || true
head -1 "$folder/info"
check "what fitted is read" grep -qE "mcap, .* [0-9]+ messages|mcap file, .* [0-9]+ messages" "$folder/info"
exit "$failed"
