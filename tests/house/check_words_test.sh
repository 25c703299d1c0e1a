#!/usr/bin/env bash
# check_words.sh refuses a private word in a name and in a file's name, and not in a comment or a text.
set -euo pipefail
check=$(realpath "$(dirname "${BASH_SOURCE[0]}")/check_words.sh")
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
cd "$house"
git init -q .
echo 'Errand: Task' >words.txt

expect() { # expect STATUS FILE TEXT
  local status=0
  printf '%s\n' "$3" >"$2"
  git add -A
  "$check" "$house" words.txt >said.txt || status=$?
  if ((status != $1)); then
    echo "expected status $1 of: $3 in $2" >&2
    cat said.txt >&2
    exit 1
  fi
  git rm -qf "$2"
}

expect 0 a.cpp 'class Task {};  // once an Errand'
expect 0 a.cpp 'const char* retired = "Errand";'
expect 1 a.cpp 'class Errand {};'
expect 1 a.cpp 'struct LongErrand {};'
mkdir -p in && expect 1 in/errand.cpp "int task;"
