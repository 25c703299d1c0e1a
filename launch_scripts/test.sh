#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Arguments go to ctest, for example: test.sh -R teb
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/launch_scripts/setup.sh" tests
"$root/launch_scripts/build.sh" release tests
if [[ -n ${BANDWAGON_SHARED:-} ]]; then
  BANDWAGON_SHARED=$(cd "$BANDWAGON_SHARED" && pwd)
  export BANDWAGON_SHARED
else
  echo "BANDWAGON_SHARED is not set: tests on recorded data are skipped."
fi
cd "$root/build/release"
exec ctest --output-on-failure -j "${BANDWAGON_JOBS:-2}" "$@"
