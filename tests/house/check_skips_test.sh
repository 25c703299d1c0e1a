#!/usr/bin/env bash
# check_skips_test.sh PROGRAM: how a test program (tests/main.cpp) ends: 77 only when tests were skipped for want of recorded data and
# nothing failed.
set -uo pipefail

program=$1
failures=0

ends_with() {  # STATUS FILTER: of the tests FILTER names
  "$program" --gtest_filter="$2" >/dev/null 2>&1
  local status=$?
  if [[ $status -ne $1 ]]; then
    echo "tests '$2' with BANDWAGON_SHARED '${BANDWAGON_SHARED-}': status $status, expected $1"
    failures=$((failures + 1))
  fi
}

unset BANDWAGON_SHARED
ends_with 0 'Sample.Passes'
ends_with 77 'Sample.Skips'
ends_with 77 'Sample.Passes:Sample.Skips'
ends_with 1 'Sample.Fails'
ends_with 1 'Sample.Skips:Sample.Fails'
ends_with 1 'Sample.NoSuchTest'
export BANDWAGON_SHARED=/somewhere
ends_with 0 'Sample.Passes'
ends_with 1 'Sample.Skips'
exit $((failures > 0))
