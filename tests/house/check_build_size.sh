#!/usr/bin/env bash
# check_build_size.sh BUILD UNITS LINES: what the compiler has to do for the robot's program, compile steps and lines read (headers in thousands of
# lines, once for each step that reads them), is at most a tenth above UNITS and LINES. A precompiled header counts where it is made.
set -euo pipefail
build=$1
cd "$build"

mapfile -t objects < <(ninja -t inputs bandwagon | grep -E '\.(o|gch)$')
((${#objects[@]} > 0)) || { echo "no objects of bandwagon in $build"; exit 1; }
printf '%s\n' "${objects[@]}" >build_size.objects

# "OBJECT: #deps N, ..." and then, indented, a file in each line. Lines of a file are counted once and added for each object.
read -r units lines < <(ninja -t deps | awk '
  BEGIN { while ((getline object < "build_size.objects") > 0) ours[object] = 1 }
  /^[^ ].*: #deps/ { counts = $1; sub(/:$/, "", counts); counts = counts in ours; units += counts; next }
  counts && NF == 1 {
    file = $1
    if (!(file in length_of)) {
      length_of[file] = 0
      if (file !~ /\.gch$/) { while ((getline line < file) > 0) ++length_of[file]; close(file) }
    }
    lines += length_of[file]
  }
  END { printf "%d %d\n", units, lines / 1000 }')
rm -f build_size.objects

echo "$units compile steps (bound $2), $lines thousand lines read (bound $3)"
if ((units * 10 > $2 * 11 || lines * 10 > $3 * 11)); then
  echo 'the build of the robot'\''s program has grown by more than a tenth: find what, or raise the bounds in tests/house/CMakeLists.txt and say why'
  exit 1
fi
