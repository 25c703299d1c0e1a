#!/usr/bin/env bash
# check_containers.sh COMPILE_COMMANDS: what moves the base is compiled with checked containers (BANDWAGON_CHECKED in cmake/bandwagon.cmake), in
# every build. Calibration moves none.
set -euo pipefail
moves='(components/(robot_base|safety|motor_control|twist_mux|laser|model)|runtime/(host|lifecycle|serial))/'
sources=$(grep '"command":' "$1" | grep -E " -c [^ ]*/$moves" | grep -vE '/(tests|calibration)/|/bw_calibration\.dir/' || true)
[[ -n $sources ]] || { echo "no sources in $1"; exit 1; }
if grep -v -- '-D_GLIBCXX_ASSERTIONS' <<<"$sources" | grep -oE '[^ ]+\.c(pp|xx)",?$'; then
  echo 'compiled without checked containers: BANDWAGON_CHECKED does not name their target'
  exit 1
fi
echo "$(wc -l <<<"$sources") sources looked at"
