#!/usr/bin/env bash
# Installs the Debian packages that are missing: setup.sh for the program, `setup.sh tests` for its tests and checks too.
# Says what it does; sudo only when not root and something is missing.
set -euo pipefail

packages=(
  g++ cmake ninja-build
  libfastrtps-dev libfastcdr-dev
  libeigen3-dev libceres-dev libyaml-cpp-dev libpng-dev liblz4-dev libsqlite3-dev libzstd-dev zlib1g-dev libssl-dev
  libspdlog-dev libfmt-dev libcli11-dev nlohmann-json3-dev
)
case ${1:-program} in
  program) ;;
  tests)
    packages+=(libgtest-dev libgmock-dev libbenchmark-dev cyclonedds-dev cyclonedds-tools procps git ccache shellcheck)
    ;;
  *)
    echo "usage: $0 [program|tests]" >&2
    exit 2
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "All ${#packages[@]} Debian packages are there."
  exit 0
fi

as_root=()
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
