#!/usr/bin/env python3
"""run_tutorials.py PAGES BIN: runs every ```bash block of the tutorials as a reader would, in the order of the page, in a copy of the
project's configuration; `bandwagon` is BIN/bandwagon. A block after `<!-- not run: why -->` is skipped and counted. A ```text block after
`<!-- output contains -->` must stand, line by line, in what the block before it printed."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

pages, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
root = pages.parent.parent
BLOCK = re.compile(r"(?P<note><!-- (?:not run: [^>]+|output contains) -->\n)?```(?P<kind>bash|text)\n(?P<text>.*?)```", re.S)


def run(block: str, folder: pathlib.Path) -> subprocess.CompletedProcess:
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}")
    return subprocess.run(["bash", "-euo", "pipefail", "-c", block], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)


def try_page(page: pathlib.Path) -> tuple[int, int]:
    ran = skipped = 0
    printed = ""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(root / "config", pathlib.Path(folder) / "config")
        for block in BLOCK.finditer(page.read_text()):
            note, kind, text = block["note"] or "", block["kind"], block["text"]
            if kind == "text":
                for line in filter(None, text.splitlines() if "output contains" in note else []):
                    if line not in printed:
                        sys.exit(f"{page.name}: expected '{line}' in:\n{printed}")
            elif "not run" in note:
                skipped += 1
            else:
                done = run(text, pathlib.Path(folder))
                printed = done.stdout
                if done.returncode != 0:
                    sys.exit(f"{page.name}: status {done.returncode} of\n{text}\n{printed}")
                ran += 1
    return ran, skipped


counts = [try_page(page) for page in sorted(pages.glob("*.md"))]
if not counts or not all(ran for ran, _ in counts):
    sys.exit("a page has no command that is run")
print(f"{len(counts)} pages, {sum(r for r, _ in counts)} blocks run, {sum(s for _, s in counts)} not run")
