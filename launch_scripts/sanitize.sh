#!/usr/bin/env bash
# sanitize.sh [asan|tsan]: the tests of what moves the base, and of the runtime below it, with the sanitizers
# for addresses and undefined behaviour (asan, the default) or with that for threads (tsan). Builds them in
# build/asan or build/tsan (a quarter of an hour on two cores from scratch) and runs them. What libraries do
# that are not instrumented, DDS above all, tests/tsan_suppressions.txt leaves out.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-asan}
tests=(
  robot_base chain_sequences kobuki eddie driver_and_firmware robot_files calibration emulators
  safety motor_control twist_mux laser lifecycle base serial worker_pool live_parameters writer_clock
  robot_base_component base_topics emergency_stop_topics robot_file_drivers
  collision_monitor_component motor_control_component twist_mux_component laser_component laser_port
  callback_failure host_lifecycle outside_manager host command_owner node_announcement dds rosout
)
case $preset in
  asan)
    tests+=(monitor_property)
    # LeakSanitizer is a part of it. What DDS keeps until the end of the process is still pointed at, and no leak.
    export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_init_order=1
    export UBSAN_OPTIONS=print_stacktrace=1
    ;;
  tsan)
    export TSAN_OPTIONS="suppressions=$root/tests/tsan_suppressions.txt:second_deadlock_stack=1:history_size=4"
    ;;
  *)
    echo "usage: $0 [asan|tsan]" >&2
    exit 2
    ;;
esac

cd "$root"
export BANDWAGON_MONITOR_CASES=${BANDWAGON_MONITOR_CASES:-300}
[[ -f build/$preset/CMakeCache.txt ]] || cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" -j "${BANDWAGON_JOBS:-2}" --target "${tests[@]/#/test_}"
cd "build/$preset"
exec ctest --output-on-failure -j "${BANDWAGON_JOBS:-2}" --timeout 1800 -R "^($(IFS='|'; echo "${tests[*]}"))$"
