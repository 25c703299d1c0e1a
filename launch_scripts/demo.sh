#!/usr/bin/env bash
# Installs what is missing, builds the program, and drives through the hallway: `bandwagon demo`, whose options it takes, for example:
# demo.sh --seed 3. With --stay it drives in real time and waits at the goal for others (the page, /goal_pose), until Ctrl-C. It serves
# the page, whose address it prints; --no-page does not, --page=PORT says where.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/launch_scripts/setup.sh"
"$root/launch_scripts/build.sh" release program
echo
exec "$root/build/release/bin/bandwagon" demo --out "$root/run/demo" "$@"
