#!/usr/bin/env bash
# left_out_test.sh SOURCE GENERATOR: a build that has none of the page's packages says so at its configuration and has a program without page.
set -euo pipefail
source=$1
generator=$2

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake -S "$source" -B "$work/build" -G "$generator" -DBANDWAGON_TESTS=OFF -DBANDWAGON_NODE_MODULES="$work/none" >"$work/said"
grep -E '^-- Page: left out of the program, .*setup\.sh' "$work/said" || { cat "$work/said"; exit 1; }
cmake --build "$work/build" --target bw_page >"$work/said" || { cat "$work/said"; exit 1; }
cat >"$work/pages.cpp" <<'EOF'
#include "components/viewer/adaptor/site.hpp"
int main() { return static_cast<int>(bw::viewer::page_files().size()); }
EOF
c++ -std=c++20 -I"$source" "$work/pages.cpp" "$work/build/components/viewer/page/libbw_page.a" -o "$work/pages"
"$work/pages" || { echo "a page of $? files was not left out"; exit 1; }
