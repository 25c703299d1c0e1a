#!/usr/bin/env bash
# The component shown in README.md is the one that the package test builds, to the letter.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
examples=$root/tests/examples
shown() { # shown LANGUAGE: what README.md shows of it
  awk -v start="^\`\`\`$1\$" '$0 ~ start {inside = 1; next} /^```$/ {inside = 0} inside' "$root/README.md"
}
diff <(shown cpp) "$examples/component/wanderer.cpp"
diff <(shown yaml) "$examples/component/graph.yaml"
diff <(shown cmake) "$examples/CMakeLists.txt"
