#!/usr/bin/env bash
# listen_test.sh ARGUMENTS OF run.sh: a test on a machine of its own, a network namespace whose one device is its loopback, with 10.77.0.1 as an address that
# others could reach. Skipped (77) where namespaces are not allowed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
own_machine=(unshare --user --map-root-user --net)
PATH=$PATH:/usr/sbin
command -v ip >/dev/null || { echo "skipped: ip (iproute2) is missing; launch_scripts/setup.sh tests installs it"; exit 77; }
"${own_machine[@]}" true 2>/dev/null || { echo "skipped: this machine allows no network namespaces"; exit 77; }
exec "${own_machine[@]}" bash -c 'ip link set lo up && ip address add 10.77.0.1/32 dev lo && exec "$@"' machine "$here/run.sh" "$@"
