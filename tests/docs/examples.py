# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""examples.py CLOTHFIT SOURCE OUT [--long] [PAGE...]: runs the shell examples of the manual's pages for users.

The blocks ```sh of a page are run in their order, in one folder with `data` and `examples` in it. A comment before a
block says otherwise:

    <!-- example: not run: WHY -->
    <!-- example: long: HOW LONG -->     only with --long; so are all after it on the page
    <!-- example: needs PROGRAM -->      only where it is installed
    <!-- example: status N -->           the last command ends with N

A block ```text after a block ```sh has lines that its output must have, where ... stands for anything.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

PAGES = (
    "README.md",
    "docs/get-it.md",
    "docs/tutorial/index.md",
    "docs/tutorial/mocap.md",
    "docs/tutorial/videos.md",
    "docs/tutorial/diagnosis.md",
    "docs/tutorial/rehearsal.md",
    "docs/importing.md",
    "docs/report.md",
    "docs/material-elsewhere.md",
    "docs/gallery.md",
    "docs/cluster.md",
    "docs/recording-cloth.md",
    "docs/concepts.md",
    "docs/troubleshooting.md",
)
BLOCK = re.compile(
    r"(?:<!-- example: (?P<mark>[^\n]*?) -->\n)?```(?P<kind>sh|text)\n(?P<text>.*?)^```$", re.M | re.S
)


def matches(expected, output):
    """Whether each line of `expected` stands in `output`."""
    for line in filter(str.strip, expected.splitlines()):
        pattern = ".*".join(re.escape(part) for part in line.strip().split("..."))
        pattern = re.sub(r"(\\ )+", r"\\s+", pattern)
        if not re.search(pattern, output):
            return line
    return None


def run_block(text, folder, clothfit):
    # Debian's own python3 comes first, which has its packages.
    path = os.pathsep.join([str(clothfit.parent), "/usr/bin", os.environ["PATH"]])
    environment = dict(os.environ, PATH=path, OPENBLAS_NUM_THREADS="1", HOME=str(folder))
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=False,
    )


def run_page(page, source, out, clothfit, with_long):
    """The number of blocks that were run, and those that were passed over with their reasons."""
    folder = out / page.replace("/", "-").removesuffix(".md")
    folder.mkdir(parents=True)
    for shared in ("data", "examples"):
        (folder / shared).symlink_to(source / shared)
    number, passed_over, output, is_cut = 0, [], None, False
    for block in BLOCK.finditer((source / page).read_text()):
        mark, text = block["mark"] or "", block["text"]
        if block["kind"] == "text":
            missed = matches(text, output) if output is not None else None
            if missed is not None:
                raise SystemExit(f"{page}: the output lacks '{missed}':\n{output}")
            output = None
            continue
        output = None
        is_cut = is_cut or (mark.startswith("long") and not with_long)
        is_missing = mark.startswith("needs ") and not shutil.which(mark.split()[1])
        if mark.startswith("not run") or is_cut or is_missing:
            passed_over.append(mark or "after a long one")
            continue
        start = time.monotonic()
        result = run_block(text, folder, clothfit)
        wanted = int(mark.split()[1]) if mark.startswith("status") else 0
        if result.returncode != wanted:
            raise SystemExit(f"{page}: status {result.returncode}, not {wanted}:\n{text}\n{result.stdout}")
        number, output = number + 1, result.stdout
        print(f"{page}: {time.monotonic() - start:.1f} s: {text.splitlines()[0]}", flush=True)
    return number, passed_over


def main():
    words = [word for word in sys.argv[1:] if word != "--long"]
    clothfit, source, out = (pathlib.Path(word).resolve() for word in words[:3])
    subprocess.run(["rm", "-rf", str(out)], check=True)
    total = 0
    for page in words[3:] or PAGES:
        number, passed_over = run_page(page, source, out, clothfit, "--long" in sys.argv)
        total += number
        for reason in passed_over:
            print(f"{page}: passed over: {reason}")
    print(f"{total} examples work")
    assert total >= 1 if words[3:] else total > 10, total


main()
