#!/usr/bin/env bash
# check_includes.sh ROOT: precompiled headers hide no missing include.
#
# A file that speaks of std::vector includes <vector>, itself or through files of this project; likewise for the other names below, which
# are those that the precompiled sets bring. What one standard header includes of another is luck and does not count. CLI11, which costs each
# source that includes it seconds, is runtime/cli/verb.cpp's alone (tests apart).
set -euo pipefail
cd "$1"

# "HEADER, or a start of it<tab>pattern of what needs it"
names='array	std::(array<|to_array)
cmath	std::(sqrt|hypot|sin|cos|tan|atan2|exp|log|pow|floor|ceil|isfinite|isnan|fmod|remainder|lerp)\(
functional	std::(function|reference_wrapper)<
limits	std::numeric_limits<
map	std::(multi)?map<
memory	std::(unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared)<
optional	std::(optional<|nullopt)
random	std::(mt19937|random_device|normal_distribution|uniform_real_distribution|uniform_int_distribution)
set	std::(multi)?set<
span	std::span[<(]
vector	std::vector<
algorithm	std::(ranges::)?(sort|stable_sort|any_of|all_of|none_of|find_if|transform|clamp|nth_element|lower_bound|upper_bound|min_element|max_element|count_if|reverse)\(
Eigen/	Eigen::
fmt/	fmt::
nlohmann/	nlohmann::
gtest/	(^|[^A-Z_])(TEST|TEST_F|TEST_P)\('

if { grep -rl --include='*.hpp' --include='*.cpp' '#include <CLI/' components runtime 2>/dev/null || true; } | grep -vx runtime/cli/verb.cpp; then
  echo "These include CLI11: declare the options by runtime/cli/verb.hpp." >&2
  exit 1
fi

mapfile -t sources < <(find . \( -path ./build -o -path ./.git \) -prune -o \( -name '*.hpp' -o -name '*.cpp' \) -printf '%P\n')
awk -v names="$names" '
  BEGIN {
    count = split(names, line, "\n")
    for (i = 1; i <= count; i++) {
      split(line[i], part, "\t")
      header[i] = part[1]
      pattern[i] = part[2]
    }
  }
  /^[ \t]*#[ \t]*include[ \t]*[<"]/ {
    match($0, /[<"][^>"]*[>"]/)
    includes[FILENAME] = includes[FILENAME] " " substr($0, RSTART + 1, RLENGTH - 2)
    next
  }
  {
    files[FILENAME]
    gsub(/"([^"\\]|\\.)*"/, "\"\"")
    sub(/\/\/.*/, "")
    for (i = 1; i <= count; i++) {
      if (!((FILENAME, i) in used) && $0 ~ pattern[i]) used[FILENAME, i] = FNR
    }
  }
  function collect(file, into, part, n, k) {  # every header that `file` reaches
    n = split(includes[file], part, " ")
    for (k = 1; k <= n; k++) {
      if (part[k] in into) continue
      into[part[k]]
      if (part[k] == "gmock/gmock.h") into["gtest/gtest.h"]
      if (part[k] ~ /\/(msg|srv|action)\/[a-z0-9_]+\.hpp$/) {  # generated (idl/compiler/emit_class.cpp)
        into["array"]
        into["span"]
        into["vector"]
      }
      if (part[k] in includes) collect(part[k], into)
    }
  }
  END {
    for (file in files) {
      delete reached
      collect(file, reached)
      for (i = 1; i <= count; i++) {
        if (!((file, i) in used)) continue
        found = 0
        for (name in reached) found = found || name == header[i] || (header[i] ~ /\/$/ && index(name, header[i]) == 1)
        if (!found) {
          print file ":" used[file, i] ": includes no <" header[i] (header[i] ~ /\/$/ ? "..." : "") ">"
          broken = 1
        }
      }
    }
    print length(files) " files looked at"
    exit broken
  }' "${sources[@]}"
