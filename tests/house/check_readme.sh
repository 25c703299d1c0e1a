#!/usr/bin/env bash
# The component shown in README.md is the one that the package test builds, to the letter.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
diff <(awk '/^```cpp$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$root/README.md") "$root/tests/interop/outside_project/wanderer.cpp"
diff <(awk '/^```yaml$/ {inside = 1; next} /^```$/ {inside = 0} inside' "$root/README.md") "$root/tests/interop/outside_project/graph.yaml"
