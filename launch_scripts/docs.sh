#!/usr/bin/env bash
# Builds the site of the project's pages and the reference of its public headers: build/site/index.html. Installs what is missing. The site needs no
# network: equations are rendered by KaTeX from Debian's package, which is copied into it.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/launch_scripts/setup.sh" docs
cd "$root"
pages=build/docs
rm -rf "$pages"

# The pages where they are, so that their links hold, and what they show.
git ls-files --cached --others --exclude-standard -- '*.md' '*.svg' '*.png' 'LICENSE' | while IFS= read -r file; do
  install -D -m 644 "$file" "$pages/$file"
done
install -D -m 644 -t "$pages/assets" docs/math.js docs/site.css
katex=/usr/share/javascript/katex
mkdir -p "$pages/assets/katex"
cp -rL "$katex/katex.min.js" "$katex/katex.min.css" "$katex/fonts" "$pages/assets/katex/"

# The pages of `bandwagon help`, in its order.
{
  cat docs/mkdocs.yml
  echo 'nav:'
  sed -nE 's/^(\S.*):$/  - "\1":/p; s/^[a-z]\S* +(\S+\.md) .*/      - \1/p' docs/help.txt
} >build/mkdocs.yml
mkdocs build --quiet --strict --config-file build/mkdocs.yml --site-dir "$root/build/site"
doxygen -q docs/Doxyfile
echo "Site:      $root/build/site/index.html"
echo "Reference: $root/build/site/api/index.html"
