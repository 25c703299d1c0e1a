#!/usr/bin/env bash
# The component, the planner and the driver shown in README.md are those that the package test builds, to the letter.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
outside=$root/tests/interop/outside_project
diff <(awk '/^```cpp$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$root/README.md") <(cat "$outside/wanderer.cpp" "$outside/pure_pursuit.cpp" "$outside/trolley.cpp")
diff <(awk '/^```yaml$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$root/README.md") "$outside/graph.yaml"
