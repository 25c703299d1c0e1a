#!/usr/bin/env bash
# check_links.py follows links, sections and paths, and names each that leads nowhere, and no other.
set -euo pipefail
check=$(realpath "$(dirname "${BASH_SOURCE[0]}")/check_links.py")
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
cd "$house"
git init -q .
mkdir -p components/a/b components/c
printf '# a\n\n## 2.1 A heading, `with` marks\n\n```\n# 9.9 no heading\n```\n' >components/a/theory.md
printf '# c\n\n## 3.1 Another\n' >components/c/theory.md
touch components/a/list.hpp components/a/list.cpp

cat >components/a/README.md <<'TEXT'
[page](theory.md), [heading](theory.md#21-a-heading-with-marks), [here](#here), [elsewhere](https://example.org/none.md), `[no](link)`
[gone](none.md) [no heading](theory.md#22-none) [none here](#none)
`components/a/list` and `components/a/*.hpp` are there, components/none.hpp is not

# here
TEXT
cat >components/a/b/code.cpp <<'TEXT'
// a/theory.md 2.1, c/theory.md 3.1 and 3.2; theory.md 2.1 could be either
// a/theory.md 9.9 is in a block of code; components/a/none.hpp
auto text = "components/in/a/text.hpp";
TEXT
printf '// theory.md 2.1\n' >components/a/list.cpp

status=0
said=$("$check" "$house") || status=$?
expected='components/a/README.md:2: none.md: no such file
components/a/README.md:2: theory.md#22-none: no such heading
components/a/README.md:2: #none: no such heading
components/a/README.md:3: components/none.hpp: no such path
components/a/b/code.cpp:1: c/theory.md has no section 3.2
components/a/b/code.cpp:1: theory.md: 2 pages end so
components/a/b/code.cpp:2: a/theory.md has no section 9.9
components/a/b/code.cpp:2: components/a/none.hpp: no such path
16 links, sections and paths, 8 lead nowhere'
if ((status != 1)) || [[ $said != "$expected" ]]; then
  diff <(echo "$expected") <(echo "$said") >&2 || true
  exit 1
fi
rm components/a/README.md components/a/b/code.cpp
"$check" "$house" >/dev/null
