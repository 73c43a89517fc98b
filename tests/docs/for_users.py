# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""for_users.py SOURCE: pages for users tell what clothfit does, not how it came to be.

They quote no commit, name no test, and say nothing of what was tried and given up: that stands in
CHANGELOG.md, docs/adr, docs/studies and tests/README.md. And what README.md says that it takes to get
clothfit are figures of docs/get-it.md.
"""

import pathlib
import re
import sys

# Of docs/ itself, for those who change clothfit or measure it.
FOR_MAINTAINERS = {"README.md", "architecture.md", "benchmarks.md", "report-internals.md"}
NEVER = (
    ("a commit", re.compile(r"(?<![#\w])(?=[0-9a-f]*[0-9])(?=[0-9a-f]*[a-f])[0-9a-f]{7,40}\b|\bof commit\b")),
    ("a test's file", re.compile(r"\btests/[\w./-]+|\b\w+_test(?:\.\w+)?\b")),
    ("what was tried", re.compile(r"\b(?:was|were) tried\b(?! in simulation)|\btried and\b|\bdid less\b")),
)


def pages(root):
    for page in sorted((root / "docs").glob("*.md")):
        if page.name not in FOR_MAINTAINERS:
            yield page
    yield from sorted((root / "docs/tutorial").glob("*.md"))
    yield from (root / "README.md", root / "python/README.md", root / "clothfit/README.md")


def suites(root):
    """Names of GoogleTest's suites, but for those that the library has for something else."""
    found, public = set(), set()
    for header in (root / "clothfit").glob("*.h"):
        public.update(re.findall(r"\w+", header.read_text()))
    for source in (root / "tests").rglob("*.cc"):
        found.update(re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),", source.read_text(), re.M))
    return found - public


def problems_of(text, names):
    for number, line in enumerate(text.splitlines(), 1):
        for what, pattern in NEVER:
            for match in pattern.finditer(line):
                yield f"{number}: {what}: {match.group(0)}"
        for quoted in re.findall(r"`([A-Z]\w+)(?:\.\w+)?`", line):
            if quoted in names:
                yield f"{number}: a test: {quoted}"


def figures(text):
    """Minutes, megabytes and gigabytes, as they stand."""
    return set(re.findall(r"\w+ minutes on two cores|\d[\d.]* [MG]B\b", text))


def main():
    root = pathlib.Path(sys.argv[1])
    names = suites(root)
    assert len(names) > 100, len(names)
    # It finds each of them.
    bad = ("of commit 10eb75e", "`tests/apps/command.cc`", "another was tried", f"`{min(names)}.Works`")
    assert {found.split(":")[0] for found in problems_of("\n".join(bad), names)} == {"1", "2", "3", "4"}
    problems, checked = [], 0
    for page in pages(root):
        checked += 1
        problems += [f"{page.relative_to(root)}:{found}" for found in problems_of(page.read_text(), names)]
    first_screen = figures((root / "README.md").read_text().split("\n## ")[0])
    assert len(first_screen) >= 3, first_screen
    known = figures((root / "docs/get-it.md").read_text())
    problems += [f"README.md: not in docs/get-it.md: {figure}" for figure in first_screen - known]
    print("\n".join(problems) or f"{checked} pages are for users")
    assert checked > 20, checked
    return 1 if problems else 0


sys.exit(main())
