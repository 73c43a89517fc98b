# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""sentences.py SOURCE: what verdicts, warnings and answers can say, against docs/troubleshooting.md.

Both ways: every sentence of the sources has to stand on the page, and every heading of the page that
quotes one has to come from the sources.
"""

import pathlib
import re
import sys

# File, and what its sentences begin and end with, where the rest is tables, keys and help of options.
SOURCES = (
    ("fitting/report/verdict/page_verdict.cc", None, None),
    ("fitting/report/verdict/sentences.cc", None, None),
    ("fitting/report/verdict/joint_verdict.cc", None, None),
    ("fitting/report/pair/verdict.cc", None, None),
    ("fitting/report/comparison_report.cc", "std::string Headline(", "int ContenderIndex("),
    ("fitting/report/recording_report.cc", "PageVerdict VerdictOf(", "ReportJson ContentSection("),
    ("fitting/report/scene/scene.cc", None, None),
    ("fitting/fit/fitter_result.cc", None, None),
    ("fitting/fit/rugged_cost.cc", None, None),
    ("fitting/fit/strategy_fit.cc", "std::string SayMesh(", "// A finer mesh, from where"),
    ("fitting/fit/two_starts.cc", "std::string SaySecondStart(", "// Of two fits"),
    ("fitting/fit/uncertainty.cc", None, None),
    ("fitting/scene/silhouettes.cc", None, None),
    ("fitting/scene/clouds.cc", None, None),
    ("fitting/diagnosis/answer/headline.cc", None, None),
    ("fitting/diagnosis/answer/summary_text.cc", None, None),
    ("fitting/diagnosis/classify/class_text.cc", None, None),
    ("fitting/diagnosis/compare/separating_motion.cc", None, None),
    ("fitting/diagnosis/locate/discrepancy_text.cc", None, None),
    ("tracking/recording/warnings/warnings.cc", None, None),
    ("tracking/recording/warnings/placement.cc", None, None),
    ("tracking/recording/warnings/silhouette.cc", None, None),
    ("tracking/recording/warnings/points.cc", None, None),
    ("tracking/recording/warnings/support.cc", None, None),
    ("tracking/outliers/outliers.cc", None, None),
    ("tracking/outliers/swapped_markers.cc", None, None),
    ("tracking/import/c3d/c3d.cc", "void FitFile(", None),
    ("tracking/import/cameras/colmap.cc", None, None),
    ("tracking/import/pictures/corner_placement.cc", None, None),
    ("tracking/import/markers/joined_tracks.cc", None, None),
    ("tracking/import/tables/marker_table.cc", None, None),
    ("tracking/import/markers/marker_take.cc", None, None),
    ("tracking/import/take/file.cc", "TakeInFile ReadTable(", "TakeFacts Agree("),
    ("tracking/import/take/layout.cc", None, None),
    ("tracking/import/take/obstacles.cc", None, None),
    ("tracking/import/take/recording.cc", None, "void CheckOptions("),
    ("tracking/import/pictures/video.cc", None, None),
    ("apps/commands/recordings/check.cc", None, "void AddCheckCommand("),
    ("apps/options/config.cc", "void PrintOutliers(", None),
    ("apps/commands/fits/diagnose.cc", None, "void AddLookOptions("),
    ("apps/commands/fits/fit_options.cc", None, None),
    ("apps/commands/fits/fit_result_text.cc", "std::string EstimateRow(", None),
    ("apps/commands/recordings/import_cameras.cc", None, "void AddCamerasOptions("),
    ("apps/commands/recordings/import.cc", "void PrintWhatIsMissing(", "void AddImportCommand("),
    ("apps/commands/fits/simulate.cc", None, "void AddSimulateCommand("),
    ("apps/commands/recordings/track.cc", "return kExitSuccess;", "void AddTrackCommand("),
)
# Input that is refused, which says itself what was expected, and the command to type next.
NO_SENTENCES = re.compile(r"throw InputError\(.*?\);|\b(?:Fail|FailAt|PrintNext)\(.*?\);", re.S)
QUOTED = (
    "Headlines of a fit",
    "Sentences of a fit",
    "Warnings about a recording",
    "Headlines of a diagnosis",
    "Sentences of a diagnosis",
    "Two runs, and comparisons",
    "Notes of an import",
    "How a command ended",
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
    sentence = re.sub(r"clothfit: (\{\})?(warning: )?", "", squeeze(sentence))
    return [part.strip(" .:;,()") for part in re.split(placeholder, sentence)]


def is_sentence(piece):
    return len([word for word in piece.split() if re.search("[A-Za-z]", word)]) >= LEAST_WORDS


def main():
    root = pathlib.Path(sys.argv[1])
    page = (root / "docs/troubleshooting.md").read_text()
    said = squeeze(page)
    sources, problems, checked = "", [], 0
    for name, begin, end in SOURCES:
        text = (root / name).read_text()
        for mark in filter(None, (begin, end)):
            assert mark in text, f"{name}: '{mark}' is gone"
        text = text[text.index(begin or "") : text.index(end) if end else None]
        for literal in literals(NO_SENTENCES.sub("", text)):
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
