#!/bin/sh
# manual_pages.sh FOLDER NAME PROGRAM...: NAME(1) and NAME-VERB(1) for each verb, by what `PROGRAM... [VERB] --help` prints.
set -eu
folder=$1 name=$2
shift 2
mkdir -p "$folder"
version=$("$@" --version | cut -d' ' -f2)
page() { # page NAME PURPOSE WORD...
  of=$1 purpose=$2
  shift 2
  help2man --no-info --no-discard-stderr --version-string="$version" --source="Bandwagon $version" --name="$purpose" "$*" |
    sed "s/^\.TH [^ ]* /.TH $(echo "$of" | tr '[:lower:]' '[:upper:]') /; 4,6s/^.* \\\\-/$of \\\\-/" | gzip -9n >"$folder/$of.1.gz"
}
page "$name" "drives wheeled robots among people" "$@"
"$@" complete "" | while read -r verb; do
  purpose=$("$@" --help | sed -n "s/^  $verb  *//p" | head -n 1)
  # Verbs of the lab stand in the robot's program as signs to it.
  case $purpose in "Of bandwagon-lab"*) continue ;; esac
  page "$name-$verb" "$purpose" "$@" "$verb"
done
