#!/usr/bin/env bash
# export_ros2_messages.sh DIR [PACKAGE...]: writes our messages as a package that ROS 2 builds with colcon, DIR/bandwagon_msgs. Any other
# package of idl/ that the ROS 2 at hand lacks (people_msgs, say) may be named instead. Builds nothing but the compiler of the messages.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if (($# == 0)) || [[ $1 == -* ]]; then
  echo "usage: $0 DIR [PACKAGE...]" >&2
  exit 2
fi
out=$(realpath -m -- "$1")
packages=("${@:2}")
((${#packages[@]})) || packages=(bandwagon_msgs)

[[ -f $root/build/release/CMakeCache.txt ]] || "$root/launch_scripts/setup.sh"
"$root/launch_scripts/build.sh" release idl_compiler
"$root/build/release/bin/bandwagon_idl_compiler" --ros2-package "$root/idl" "$out" "${packages[@]}"
echo
echo "To build that, in a colcon workspace, with ROS 2 sourced:"
echo "  colcon build --base-paths $(printf '%q ' "${packages[@]/#/$out/}")--packages-select ${packages[*]} && . install/setup.bash"
