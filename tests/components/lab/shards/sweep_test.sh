#!/usr/bin/env bash
# sweep_test.sh ROOT PROGRAM: sweep.sh on two hosts of which one is lost; what is merged is one run. Both are this machine: "ssh" runs the command here.
set -euo pipefail
root=$1
export BANDWAGON=$2
command -v parallel >/dev/null || { echo "skipped: GNU parallel is not here" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "sweep_test: $*" >&2 && exit 1; }

# The host "lost" breaks off each of its first two commands in the middle.
cat >"$work/ssh" <<'S'
#!/usr/bin/env bash
# HOST COMMAND, after options of ssh
while [[ $1 == -* ]]; do
  [[ $1 == -o || $1 == -l ]] && shift
  shift
done
host=$1
shift
[[ $1 != -- ]] || shift
[[ $host != lost || -f $(dirname "$0")/broken2 ]] || {
  [[ ! -f $(dirname "$0")/broken1 ]] || touch "$(dirname "$0")/broken2"
  touch "$(dirname "$0")/broken1"
  timeout --signal=KILL 0.5 bash -c "$*" || exit 255
}
export SHELL=/bin/bash # as sshd does; where the tests run it may not be set, and without it parallel's worker runs nothing
exec bash -c "$*"
S
chmod +x "$work/ssh"
export PARALLEL_SSH=$work/ssh PARALLEL_HOME=$work/home
mkdir "$PARALLEL_HOME" && touch "$PARALLEL_HOME/will-cite"
suite=(hallway --planners=teb --episode=light --seeds=3..6)
hashes() { grep -o '"samples_sha256": "[0-9a-f]*"' "$1"; }

cd "$work"
"$BANDWAGON" evaluate "$root/config/suites/hallway.yaml" "${suite[@]:1}" --json one.json >/dev/null 2>&1
"$root/launch_scripts/sweep.sh" 1/lost,1/other out.json 4 "$root/config/suites/hallway.yaml" "${suite[@]:1}" >sweep.log 2>&1 || { cat sweep.log out.json.shards/*.log && fail "it failed"; }
[[ -f broken1 ]] || fail "no command went to the host that is lost"
[[ $(hashes one.json | wc -l) == 4 ]] || fail "one run has not four drives"
[[ $(hashes one.json) == $(hashes out.json) ]] || fail "merged it is another evaluation"
grep -q '"complete": true' out.json || fail "it is not complete"
[[ ! -e out.json.shards ]] || fail "shards are left"

# What cannot be driven is said, and kept.
if "$root/launch_scripts/sweep.sh" 1/other bad.json 2 no_such_suite.yaml >bad.log 2>&1; then fail "a suite that is not there was driven"; fi
grep -q "not complete: shards 1 2 of 2" bad.log || { cat bad.log && fail "it was not said which shards are missing"; }
echo passed
