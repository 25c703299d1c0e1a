#!/usr/bin/env python3
"""check_links.py ROOT: what pages and comments refer to is there.

    [text](page.md#heading)    in pages: file and heading, slugs as GitHub and the site make them
    dwa/theory.md 5.9          in comments and texts of code: one page whose path ends so, or in the file's own folder, and its heading 5.9
    components/model/arc.hpp   in pages and comments: paths from the root; * stands for anything

Prints each that leads nowhere as FILE:LINE: WHAT, and how many it followed; status 1 if there was one.
"""
import functools
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1]).resolve()
listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root, capture_output=True, text=True, check=True)
files = [name for name in listed.stdout.splitlines() if (root / name).is_file()]
pages = {name: (root / name).read_text() for name in files if name.endswith(".md")}

LINK = re.compile(r"(?<!`)\[[^\]]*\]\(([^)\s]+)\)")
SECTION = re.compile(r"((?:[\w.]+/)*\w+\.md) (\d+\.\d+)((?:(?:, | and | to )\d+\.\d+)*)")
PATH = re.compile(r"(?<![\w./$}-])((?:components|runtime|tests|config|docs|launch_scripts|cmake)/[\w./*-]*\w)(?![\w*{<$])")


def headings(text):
    """Of a page, without those in blocks of code."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    return [match.group(1).strip() for match in re.finditer(r"^#+ (.*)$", text, flags=re.M)]


def slug(heading):
    return re.sub(r"[^\w\s-]", "", heading).strip().lower().replace(" ", "-")


slugs = {name: {slug(h) for h in headings(text)} for name, text in pages.items()}
numbers = {name: {h.split()[0] for h in headings(text) if h} for name, text in pages.items()}


def link_fault(name, target):
    file, _, anchor = target.partition("#")
    there = (root / name).parent / file if file else root / name
    if not there.exists():
        return f"{target}: no such file"
    page = str(there.resolve().relative_to(root)) if there.is_file() else ""
    return f"{target}: no such heading" if anchor and page in slugs and anchor not in slugs[page] else None


def section_fault(name, page, number):
    own = str(pathlib.PurePath(name).parent / page)
    found = [own] if own in pages else [p for p in pages if p == page or p.endswith("/" + page)]
    if len(found) != 1:
        return f"{page}: {len(found)} pages end so"
    return None if number in numbers[found[0]] else f"{page} has no section {number}"


@functools.cache
def path_fault(path):
    return None if any(root.glob(path)) or any(root.glob(path + ".*")) else f"{path}: no such path"


def comment(name, text):
    if name.endswith(".md"):
        return text
    return text.partition("//" if re.search(r"\.([ch]pp|m?[jt]s)$", name) else "#")[2]


followed, faults = 0, []
for name in files:
    if not re.search(r"(\.(md|[ch]pp|ts|mjs|py|yaml|txt|cmake)|(?<!_test)\.sh)$", name):  # tests of the house make up their own trees
        continue
    for line, text in enumerate((root / name).read_text(errors="replace").splitlines(), 1):
        found = [link_fault(name, t) for t in LINK.findall(text) if not re.match(r"[a-z]+:", t)] if name.endswith(".md") else []
        found += [section_fault(name, page, n) for page, first, more in (SECTION.findall(text) if ".md " in text else ()) for n in [first, *re.findall(r"\d+\.\d+", more)]]
        found += [path_fault(path) for path in PATH.findall(comment(name, text))]
        followed += len(found)
        faults += [f"{name}:{line}: {fault}" for fault in found if fault]
print("\n".join([*faults, f"{followed} links, sections and paths, {len(faults)} lead nowhere"]))
sys.exit(bool(faults))
