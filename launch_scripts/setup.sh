#!/usr/bin/env bash
# Installs the Debian packages that are missing: setup.sh for the program, `setup.sh tests` for its tests and checks too, and the packages
# that tests/interop/mcap_core runs on Node.js. Says what it does; sudo only when not root and something is missing.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
what=${1:-program}

packages=(
  g++ cmake ninja-build
  libfastrtps-dev libfastcdr-dev
  libeigen3-dev libceres-dev libyaml-cpp-dev libpng-dev liblz4-dev libsqlite3-dev libzstd-dev zlib1g-dev libssl-dev
  libboost-dev libspdlog-dev libfmt-dev libcli11-dev nlohmann-json3-dev
)
case $what in
  program) ;;
  tests)
    packages+=(libgtest-dev libgmock-dev libbenchmark-dev cyclonedds-dev cyclonedds-tools procps git ccache shellcheck)
    # Not by the names of the packages: a nodejs from elsewhere brings npm with it, and Debian's npm would not go beside it.
    command -v node >/dev/null || packages+=(nodejs)
    command -v npm >/dev/null || packages+=(npm)
    ;;
  *)
    echo "usage: $0 [program|tests]" >&2
    exit 2
    ;;
esac

install_debian_packages() {
  local package status missing=() as_root=()
  for package in "${packages[@]}"; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [[ $status == installed ]] || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then
    echo "All ${#packages[@]} Debian packages are there."
    return
  fi
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "These Debian packages are missing and sudo is not installed; install them as root: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "Installing from Debian: ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# Into build/node, as the lock file says. Without them everything else is tested all the same: a failure is told, and the test skips itself.
install_node_packages() {
  local from=$root/tests/interop/mcap_core to=$root/build/node
  if [[ -f $to/node_modules/.package-lock.json ]] && cmp -s "$from/package-lock.json" "$to/package-lock.json"; then
    echo "The packages for Node.js are there."
    return
  fi
  mkdir -p "$to"
  rm -rf "$to/node_modules" "$to/package-lock.json"
  cp "$from/package.json" "$from/package-lock.json" "$to"
  echo "Installing packages for Node.js into build/node"
  if ! (cd "$to" && npm ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --loglevel=error); then
    rm -rf "$to"
    echo "The packages for Node.js could not be installed: the test mcap_core will be skipped." >&2
  fi
}

install_debian_packages
[[ $what == program ]] || install_node_packages
