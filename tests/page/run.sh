#!/usr/bin/env bash
# run.sh MODULES browser|node FILE.mjs ARGUMENTS...: runs a test on Node.js. Ends with 77, skipped, where Node.js, the packages or, for `browser`, chromium
# is missing (launch_scripts/setup.sh tests).
set -euo pipefail
modules=$1
needs=$2
shift 2

skip() {
  echo "skipped: $1; launch_scripts/setup.sh tests installs what is missing"
  exit 77
}
command -v node >/dev/null || skip "Node.js is missing"
[[ -d $modules/node_modules/puppeteer-core ]] || skip "the packages in $modules are missing"
[[ $needs == node ]] || command -v "${BANDWAGON_CHROMIUM:-chromium}" >/dev/null || skip "chromium is missing"
export BANDWAGON_NODE_MODULES=$modules
exec node "$@"
