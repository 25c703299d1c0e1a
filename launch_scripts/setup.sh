#!/usr/bin/env bash
# Installs what is missing: setup.sh for the program, `setup.sh tests` for its tests and checks too, `setup.sh package` for Debian packages (`arm64`: for those of another processor), `setup.sh docs` for the site. Debian packages, and into build/node the packages of
# components/viewer/page, which the page is built from. Says what it does; sudo only when not root and something is missing.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
what=${1:-program}

# Debian 13 has Fast DDS 3 under a name of its own; Debian 12 and Ubuntu 24.04 (not tried) have Fast DDS 2.
fast_dds=libfastrtps-dev
# shellcheck source=/dev/null
[[ ! -r /etc/os-release ]] || case $(. /etc/os-release && echo "$ID ${VERSION_ID:-testing}") in
  "debian 12" | "ubuntu 24.04") ;;
  "debian "*) fast_dds=libfastdds-dev ;;
  *) echo "Neither Debian 12 or 13 nor Ubuntu 24.04: the names of packages are Debian 12's, and nothing was tried here." >&2 ;;
esac

packages=(
  g++ cmake ninja-build
  "$fast_dds" libfastcdr-dev
  libeigen3-dev libceres-dev libyaml-cpp-dev libpng-dev liblz4-dev libsqlite3-dev libzstd-dev zlib1g-dev libssl-dev
  libboost-dev libspdlog-dev libfmt-dev libcli11-dev nlohmann-json3-dev
)
case $what in
  program) ;;
  arm64) packages=(g++ cmake ninja-build help2man dpkg-dev lintian file git crossbuild-essential-arm64 qemu-user
    libssl-dev libeigen3-dev libcli11-dev nlohmann-json3-dev) ;;
  package) packages+=(help2man dpkg-dev lintian file git) ;;
  docs) packages=(mkdocs mkdocs-material mkdocs-material-extensions python3-pymdownx libjs-katex doxygen git) ;;
  tests) packages+=(python3 libgtest-dev libgmock-dev libbenchmark-dev cyclonedds-dev cyclonedds-tools procps git ccache shellcheck) ;;
  *)
    echo "usage: $0 [program|tests|package|arm64|docs]" >&2
    exit 2
    ;;
esac

install_debian_packages() {
  local package processor missing=() as_root=()
  for package in "$@"; do
    processor=$(dpkg --print-architecture)
    [[ $package != *:* ]] || processor=${package#*:}
    dpkg-query --show --showformat='${Architecture} ${db:Status-Status}\n' "$package" 2>/dev/null | grep -xE "($processor|all) installed" >/dev/null ||
      missing+=("$package")
  done
  ((${#missing[@]} > 0)) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "These Debian packages are missing and sudo is not installed; install them as root: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing from Debian: ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  "${as_root[@]}" apt-get update -q &&
    "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# install_programs WITHOUT PROGRAM[=PACKAGE]...: what the robot drives without; WITHOUT says what will be lacking. Asked for by the programs and not by
# the packages: a nodejs from elsewhere brings npm with it, and Debian's npm would not go beside it.
install_programs() {
  local without=$1 program missing=()
  shift
  for program in "$@"; do
    command -v "${program%=*}" >/dev/null || missing+=("${program#*=}")
  done
  ((${#missing[@]} == 0)) || install_debian_packages "${missing[@]}" || echo "${missing[*]} could not be installed: $without." >&2
}

# As the lock file says; once. `tests` takes more of them than the program does, and what the tests have is enough for the program.
install_node_packages() {
  local from=$root/components/viewer/page to=$root/build/node without=$1 options=(--ignore-scripts --no-audit --no-fund --fetch-retries=1 --loglevel=error)
  if cmp -s "$from/package-lock.json" "$to/package-lock.json" && grep -qsE "^($what|tests)\$" "$to/installed_for"; then
    echo "The packages for Node.js are there."
    return
  fi
  [[ $what == tests ]] || options+=(--omit=dev)
  rm -rf "$to"
  mkdir -p "$to"
  cp "$from/package.json" "$to"
  cp "$from/package-lock.json" "$to"
  echo "Installing packages for Node.js into build/node"
  if command -v npm >/dev/null && (cd "$to" && npm ci "${options[@]}"); then
    echo "$what" >"$to/installed_for"
  else
    rm -rf "$to"
    echo "The packages for Node.js could not be installed: $without." >&2
  fi
}

if [[ $what == arm64 ]]; then
  if ! dpkg --print-foreign-architectures | grep -qx arm64; then
    ((EUID == 0)) || sudo=sudo
    ${sudo:-} dpkg --add-architecture arm64
    ${sudo:-} apt-get update -q
  fi
  for package in "$fast_dds" lib{fastcdr,ceres,yaml-cpp,png,lz4,sqlite3,zstd,ssl,boost,spdlog,fmt}-dev zlib1g-dev; do packages+=("$package:arm64"); done
fi
install_debian_packages "${packages[@]}"
echo "All ${#packages[@]} Debian packages are there."
[[ $what != docs ]] || exit 0
without="the program is built without its page"
[[ $what != tests ]] || without+=", and tests on Node.js are skipped"
install_programs "$without" node=nodejs npm
[[ $what != tests ]] || install_programs "tests in a browser are skipped" chromium
[[ $what != tests ]] || install_programs "completion in a zsh is not tried" zsh
[[ $what != tests ]] || install_programs "tests on a machine of their own are skipped" ip=iproute2
install_node_packages "$without"
