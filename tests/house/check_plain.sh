#!/usr/bin/env bash
# check_plain.sh ROOT: the node on plain Fast DDS that tests our services and actions from outside shares nothing with us, neither code of
# the runtime nor what the interface compiler makes; and so do the tests that speak through it. Except how the versions of Fast DDS spell things.
set -euo pipefail
cd "$1"

files=$(ls tests/interop/{plain,nav2_tree}/*.[ch]pp tests/interop/{service_process,service_golden,action_process,on_the_wire}.hpp \
  tests/interop/{service_wire,service_faults,node_services,action_wire,action_faults}_test.cpp)
# shellcheck disable=SC2086
if grep -nE '#[ \t]*include[ \t]*["<]((runtime|components|idl)/|[a-z0-9_]+/(msg|srv|action)/)' $files runtime/dds/fast_dds.hpp |
  grep -v ':#include "runtime/dds/fast_dds.hpp"$'; then
  echo 'the other side of the wire includes what is ours'
  exit 1
fi
echo "$(wc -w <<<"$files") files of the other side looked at"
