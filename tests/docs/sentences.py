# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""sentences.py SOURCE: what verdicts, warnings and answers can say, against docs/troubleshooting.md.

Both ways: every sentence of the sources has to stand on the page, and every heading of the page that
quotes one has to come from the sources.
"""

import pathlib
import re
import sys

# File, and the line from which on its texts are tables and keys, not sentences.
SOURCES = (
    ("fitting/report/page_verdict.cc", None),
    ("fitting/report/joint_verdict.cc", None),
    ("fitting/fit/rugged_cost.cc", None),
    ("tracking/recording/warnings.cc", None),
    ("tracking/recording/point_warnings.cc", None),
    ("apps/check_command.cc", "void AddCheckCommand("),
    ("fitting/diagnosis/answer/headline.cc", None),
    ("fitting/diagnosis/answer/summary_text.cc", None),
)
QUOTED = (
    "Headlines of a fit", "Sentences of a fit", "Warnings about a recording", "Headlines of a diagnosis",
    "Sentences of a diagnosis",
)
LEAST_WORDS = 3  # of a piece between two placeholders that must stand on the page


def literals(text):
    """The string literals of C++, adjacent ones joined."""
    text = re.sub(r"^\s*(//|#include).*$", "", text, flags=re.M)
    one = r'"((?:[^"\\]|\\.)*)"'
    for match in re.finditer(rf"{one}(?:\s*{one})*", text):
        parts = re.findall(one, match.group(0))
        yield "".join(parts).replace("\\n", " ").replace('\\"', '"')


def squeeze(text):
    return re.sub(r"\s+", " ", text)


def pieces(sentence, placeholder):
    sentence = squeeze(sentence).replace("clothfit: warning: ", "")
    return [part.strip(" .:;,()") for part in re.split(placeholder, sentence)]


def is_sentence(piece):
    return len([word for word in piece.split() if re.search("[A-Za-z]", word)]) >= LEAST_WORDS


def main():
    root = pathlib.Path(sys.argv[1])
    page = (root / "docs/troubleshooting.md").read_text()
    said = squeeze(page)
    sources, problems, checked = "", [], 0
    for name, end in SOURCES:
        text = (root / name).read_text()
        if end:
            assert end in text, f"{name}: '{end}' is gone"
            text = text[: text.index(end)]
        for literal in literals(text):
            sources += squeeze(literal) + "\n"
            for piece in pieces(literal, r"\{[^}]*\}"):
                if not is_sentence(piece):
                    continue
                checked += 1
                if piece not in said:
                    problems.append(f"{name}: not on the page: {piece}")
    section = ""
    for line in page.splitlines():
        if line.startswith("## "):
            section = line[3:]
        if not line.startswith("### ") or section not in QUOTED:
            continue
        for piece in pieces(line[4:], "…"):
            if not is_sentence(piece):
                continue
            checked += 1
            if piece not in sources:
                problems.append(f"troubleshooting.md: nothing says: {piece}")
    print("\n".join(problems) or f"{checked} pieces of sentences agree")
    assert checked > 100, checked
    return 1 if problems else 0


sys.exit(main())
