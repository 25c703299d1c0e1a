#!/usr/bin/env bash
# check_words.sh ROOT [LIST]: no file and no name in C++ has a word of the list (tests/house/words.txt), for which the field has another. Comments
# and texts in quotes are not looked at: a retired parameter is named in one.
set -euo pipefail
cd "$1"
list=${2:-tests/house/words.txt}

found=0
while IFS= read -r line; do
  word=${line%%:*} instead=${line#*: }
  pattern="(\\b|_|[a-z0-9])$word"
  [[ $word =~ ^[a-z] ]] && pattern="(\\b|_)$word(_|\\b)"
  hits=$(git ls-files -- '*.hpp' '*.cpp' | xargs perl -ne '
      BEGIN { $p = shift @ARGV } s{//.*}{}; s{"(\\.|[^"\\])*"}{""}g unless /^\s*#/; print "$ARGV:$.: $_" if /$p/; close ARGV if eof' "$pattern")
  hits+=$(git ls-files -- '*.hpp' '*.cpp' | grep -E "/[^/]*(\\b|_)${word,,}[^/]*$" || true)
  [[ -z $hits ]] && continue
  echo "$hits"
  echo "  the field calls this $instead"
  found=1
done < <(grep -v '^#' "$list")
exit "$found"
