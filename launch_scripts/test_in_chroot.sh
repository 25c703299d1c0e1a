#!/usr/bin/env bash
# test_in_chroot.sh bookworm|trixie [demo|test|package|image|arm64]: the project on a bare Debian, as a newcomer has it; without a second word demo, test and
# package. As root, since it makes a chroot (mmdebstrap).
#
#   demo      ./launch_scripts/demo.sh of a fresh clone
#   test      ./launch_scripts/test.sh
#   package   launch_scripts/package.sh; then, on another bare system: install, drive as two users, build the examples, complete, upgrade, purge
#   image     an OCI image of the installed program (buildah), and a drive in it
#   arm64     package.sh --arm64; then under qemu-user the hallway twice, and the change files (tests/changes), which this processor wrote
#
# Set-up runs as root with the network of this machine; everything else as a user without rights, in a network namespace with lo alone. The commit
# that is checked out is tested. Chroots are kept below BANDWAGON_CHROOTS (/var/tmp/bandwagon-chroots), so that it goes on where it was; remove that
# folder to begin anew. BANDWAGON_SHARED: recorded data for the tests.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
suite=${1:-}
case $suite in
  bookworm | trixie) ;;
  *)
    sed -n '2,4s/^# //p' "$0" >&2
    exit 2
    ;;
esac
shift
((EUID == 0)) || exec sudo --preserve-env=BANDWAGON_CHROOTS,BANDWAGON_SHARED,BANDWAGON_JOBS "$0" "$suite" "$@"
(($# > 0)) || set -- demo test package

chroots=${BANDWAGON_CHROOTS:-/var/tmp/bandwagon-chroots}
home=/home/newcomer
say() { printf '\n== %s: %s\n' "$suite" "$*"; }

install_here() { # install_here PROGRAM...: on this machine, by the packages of those names
  local program
  for program in "$@"; do
    command -v "$program" >/dev/null || { apt-get update -q && apt-get install -y -q --no-install-recommends "$program"; }
  done
}

# bare NAME: a Debian with nothing but apt, git's certificates and two users.
bare() {
  local system=$chroots/$1
  if [[ ! -f $system/etc/bandwagon-chroot ]]; then
    install_here mmdebstrap
    mkdir -p "$chroots"
    rm -rf "$system"
    say "making $system"
    mmdebstrap --quiet --variant=minbase --include=ca-certificates "$suite" "$system"
    # The package mirrors' certificates and settings of this machine, where it has any.
    cp -r /usr/local/share/ca-certificates/. "$system/usr/local/share/ca-certificates/" 2>/dev/null || true
    [[ ! -f ~/.npmrc ]] || cp ~/.npmrc "$system/root/.npmrc"
    chroot "$system" update-ca-certificates >/dev/null 2>&1
    chroot "$system" useradd --create-home newcomer
    chroot "$system" useradd --create-home guest
    date >"$system/etc/bandwagon-chroot"
  fi
}

# With NAME as the root: mounts of their own, gone when the command ends. `online` as root; `offline USER` with lo alone.
inside() { # inside NAME UNSHARE_OPTIONS... -- CHROOT_OPTIONS... -- COMMAND...
  local system=$chroots/$1 spaces=() as=()
  shift
  while [[ $1 != -- ]]; do spaces+=("$1") && shift; done
  shift
  while [[ $1 != -- ]]; do as+=("$1") && shift; done
  shift
  # shellcheck disable=SC2016  # the inner shell expands
  unshare --mount --pid --fork --kill-child "${spaces[@]}" bash -euc '
    system=$1 shared=$2
    shift 2
    mount --make-rprivate /
    mount --bind "$system" "$system"
    cd "$system"
    mount -t proc proc proc
    mount --bind /dev dev
    mount -t devpts -o mode=0620,gid=5 devpts dev/pts
    mount -t tmpfs tmpfs dev/shm
    mount -t tmpfs tmpfs run
    if [ -n "$shared" ]; then mkdir -p shared && mount --bind -o ro "$shared" shared; fi
    ip link set lo up 2>/dev/null || true
    # The root itself, since the kernel gives a process in a chroot no user namespace.
    pivot_root . mnt
    cd /
    umount --lazy mnt
    exec chroot "$@"' inside "$system" "${BANDWAGON_SHARED:-}" "${as[@]}" / \
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM="${TERM:-dumb}" LANG=C.UTF-8 BANDWAGON_JOBS="${BANDWAGON_JOBS:-2}" \
    ${BANDWAGON_SHARED:+BANDWAGON_SHARED=/shared} ${NODE_EXTRA_CA_CERTS:+NODE_EXTRA_CA_CERTS="$NODE_EXTRA_CA_CERTS"} "$@"
}
online() { # online NAME COMMAND...
  local name=$1
  shift
  inside "$name" -- -- HOME=/root DEBIAN_FRONTEND=noninteractive "$@"
}
offline() { # offline NAME USER COMMAND...
  local name=$1 user=$2
  shift 2
  inside "$name" --net -- --userspec="$user:$user" -- HOME="/home/$user" USER="$user" "$@"
}
timed() { # timed WHAT COMMAND...
  local what=$1 start=$SECONDS status=0
  shift
  "$@" || status=$?
  say "$what: $(((SECONDS - start) / 60)) min $(((SECONDS - start) % 60)) s, status $status"
  return "$status"
}

here=$suite # the chroot with the sources
clone() { # into it, as it is committed
  bare "$here"
  local to=$chroots/$here$home/bandwagon
  if [[ ! -d $to/.git ]]; then
    git clone -q "$root" "$to"
  else
    git -C "$to" -c safe.directory="$to" fetch -q "$root" HEAD
    git -C "$to" -c safe.directory="$to" reset -q --hard FETCH_HEAD
  fi
  chroot "$chroots/$here" chown -R newcomer: "$home/bandwagon"
}
set_up() { # set_up WHAT: as root, and the packages of Node.js for the user
  timed "setup.sh $1" online "$here" "$home/bandwagon/launch_scripts/setup.sh" "$1"
  chroot "$chroots/$here" chown -R newcomer: "$home/bandwagon"
}
in_clone() { # in_clone COMMAND: as the user, from the clone
  offline "$here" newcomer bash -euc "cd $home/bandwagon && $1"
}

test_demo() {
  clone
  set_up program
  timed demo.sh in_clone "./launch_scripts/demo.sh --no-page"
  timed "demo.sh again" in_clone "./launch_scripts/demo.sh --no-page"
}

test_test() {
  clone
  set_up tests
  timed test.sh in_clone "./launch_scripts/test.sh"
}

installed=$suite-installed
test_package() {
  clone
  set_up package
  online "$suite" git config --system --get-all safe.directory >/dev/null || online "$suite" git config --system safe.directory '*'
  timed package.sh in_clone "./launch_scripts/package.sh"
  sum() { (cd "$chroots/$suite$home/bandwagon/build/packages" && sha256sum ./*.deb); }
  local first
  first=$(sum)
  in_clone "rm -rf build/packages && ./launch_scripts/package.sh >/dev/null"
  [[ $(sum) == "$first" ]] && say "packed twice, the same bytes" && echo "$first"

  rm -rf "${chroots:?}/$installed"
  bare "$installed"
  mkdir -p "$chroots/$installed/packages"
  cp "$chroots/$suite$home/bandwagon/build/packages"/*.deb "$chroots/$installed/packages"
  online "$installed" apt-get update -q >/dev/null
  timed "apt install ./bandwagon" online "$installed" bash -c 'apt-get install -y -q --no-install-recommends /packages/bandwagon_*.deb >/var/log/bandwagon-install 2>&1 || { cat /var/log/bandwagon-install; exit 1; }'
  local user
  for user in newcomer guest newcomer; do
    timed "bandwagon demo as $user" offline "$installed" "$user" bash -c 'cd /tmp && bandwagon demo --no-page'
  done
  offline "$installed" guest bandwagon robots
  say "completion in bash"
  # shellcheck disable=SC2016  # the inner shell expands
  offline "$installed" guest bash -c '. /usr/share/bash-completion/completions/bandwagon
    for line in "bandwagon re" "bandwagon run ha" "bandwagon run hallway --set robot=ko" "bandwagon run hallway --set local_planner.algorithm=te"; do
      COMP_LINE=$line COMP_POINT=${#line} COMPREPLY=()
      _bandwagon bandwagon 2>/dev/null
      echo "$line<TAB>: ${COMPREPLY[*]}"
    done'
  say "component, planner and driver against bandwagon-dev alone"
  online "$installed" bash -c 'apt-get install -y -q --no-install-recommends /packages/bandwagon-dev_*.deb /packages/bandwagon-lab_*.deb g++ cmake make >/var/log/bandwagon-install 2>&1 || { cat /var/log/bandwagon-install; exit 1; }'
  offline "$installed" newcomer bash -euc 'cp -r /usr/share/bandwagon/examples /tmp/examples && cd /tmp/examples && cmake -S . -B build >/dev/null && cmake --build build &&
    bandwagon run component/graph.yaml --clock lockstep --for 1'
  offline "$installed" newcomer bash -euc 'cd /tmp && bandwagon evaluate small_house --help >/dev/null && bandwagon --version && bandwagon-lab --version'
  say "a changed robot file outlives an upgrade; purge leaves nothing"
  # shellcheck disable=SC2016  # the inner shell expands
  online "$installed" bash -euc 'echo "# mine" >>/etc/bandwagon/robots/kobuki.yaml
    mkdir /tmp/older && cd /tmp/older && dpkg-deb -R /packages/bandwagon_*.deb older && sed -i "s/^Version: /Version: 9:/" older/DEBIAN/control &&
      echo "# newer" >>older/etc/bandwagon/robots/eddie.yaml && dpkg-deb -b older newer.deb >/dev/null
    dpkg --remove bandwagon-dev bandwagon-lab >/dev/null
    dpkg -i --force-confold newer.deb >/dev/null
    tail -n 1 /etc/bandwagon/robots/kobuki.yaml /etc/bandwagon/robots/eddie.yaml
    find / -xdev -name "*bandwagon*" -not -path "/proc/*" -not -path "/packages*" -not -path "/tmp/*" -not -path "/home/*" | sort >/var/log/before
    dpkg --purge bandwagon bandwagon-dev bandwagon-lab >/dev/null
    find / -xdev -name "*bandwagon*" -not -path "/proc/*" -not -path "/packages*" -not -path "/tmp/*" -not -path "/home/*" -not -path "/var/log/*" \
      -not -path /etc/bandwagon-chroot | sort | sed "s/^/left: /"'
}

test_image() {
  install_here buildah
  export BUILDAH_ISOLATION=chroot STORAGE_DRIVER=vfs
  local packages=$chroots/$suite$home/bandwagon/build/packages archive=$chroots/bandwagon-$suite.tar container
  [[ -n $(ls "$packages"/bandwagon_*.deb 2>/dev/null) ]] || test_package
  local system=$chroots/$suite-image.tar
  install_here mmdebstrap
  # Only what drives: no documentation, no lists of packages.
  # shellcheck disable=SC2016,SC2012  # the hooks' shell expands; names of packages are plain
  mmdebstrap --quiet --variant=essential --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-exclude=/usr/share/man/*' \
    --dpkgopt='path-exclude=/usr/share/locale/*' --include="$(dpkg-deb -f "$packages"/bandwagon_*.deb Depends | sed 's/ *([^)]*)//g; s/ *|[^,]*//g; s/ //g')" \
    --customize-hook="copy-in $packages/$(cd "$packages" && ls bandwagon_*.deb) /" --customize-hook='chroot "$1" sh -c "dpkg -i /bandwagon_*.deb && rm /bandwagon_*.deb"' \
    --customize-hook='install -d -o 1000 -g 1000 "$1/home/robot"' --customize-hook='rm -rf "$1"/var/lib/apt/lists/* "$1"/var/cache/*' "$suite" "$system"
  container=$(buildah from scratch)
  buildah add -q "$container" "$system" / >/dev/null
  buildah config --user 1000:1000 --env HOME=/home/robot --entrypoint '["bandwagon"]' --cmd 'demo --stay' --workingdir /home/robot "$container"
  rm -f "$archive"
  buildah commit -q "$container" "oci-archive:$archive" >/dev/null
  say "image: $(du -m "$archive" | cut -f1) MB: $archive"
  rm "$system"
  timed "bandwagon demo in the image" buildah run --network none "$container" -- bandwagon demo --no-page
  buildah rm "$container" >/dev/null
}

# In a chroot of its own: libceres-dev of two processors do not go beside each other.
test_arm64() {
  here=$suite-arm64
  clone
  set_up arm64
  timed "package.sh --arm64" in_clone "./launch_scripts/package.sh --arm64"
  local program="qemu-aarch64 build/arm64/bin/bandwagon" run component
  for run in 1 2; do
    timed "hallway under qemu-user" in_clone "$program run hallway --clock lockstep --seed 1 --json build/arm64/run_$run.json"
    grep -E '"(samples_sha256|time_to_goal_s|path_length_m|collisions|closest_person_m)"' "$chroots/$here$home/bandwagon/build/arm64/run_$run.json"
  done
  [[ $(grep -h samples_sha256 "$chroots/$here$home/bandwagon/build/arm64"/run_[12].json | sort -u | wc -l) == 1 ]]
  say "the hallway twice, the same bytes"
  for component in collision_monitor global_planner local_costmap local_planner localization navigator people; do
    # 1: the bytes differ from those of the bag; the text is the rule.
    in_clone "$program replay tests/changes/hallway.mcap --graph config/graphs/hallway.yaml --run $component --text build/arm64/$component.txt >/dev/null ||
      ((\$? == 1)); diff tests/changes/$component.txt build/arm64/$component.txt"
    echo "$component: as tests/changes/$component.txt"
  done
}

for what in "$@"; do
  here=$suite
  case $what in
    demo | test | package | image | arm64) "test_$what" ;;
    *)
      echo "demo, test, package, image or arm64, not $what" >&2
      exit 2
      ;;
  esac
done
