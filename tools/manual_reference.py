# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""manual_reference.py CLOTHFIT OUT: the manual's reference, from what the command says of itself.

Writes OUT/commands.md (every --help), OUT/configuration.md (every key of a config.yaml with its
default) and OUT/terms.md (every force term and parameter).
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile


def run(clothfit, *words):
    return subprocess.run([clothfit, *words], check=True, stdout=subprocess.PIPE, text=True).stdout


def listed(help_text):
    """Groups of commands: [(title, [(name, description)])]."""
    groups = []
    for title, rows in re.findall(r"^(\S.*):\n((?:  .*\n)+)", help_text, re.M):
        if title in ("Options", "Arguments", "Examples", "Example"):
            continue
        joined = re.sub(r"\n {14}", " ", rows)  # kCommandColumn of apps/command_line/help_text.cc
        found = re.findall(r"^  (\S+) +(.*)$", joined, re.M)
        assert len(found) == len(joined.splitlines()), f"{title}: a line is of no command:\n{rows}"
        groups.append((title, found))
    return groups


def command_sections(clothfit, words, level):
    text = run(clothfit, *words, "--help")
    mark = "#" * level
    yield f"{mark} {' '.join(words)}\n\n```text\n{text.rstrip()}\n```\n"
    for _, rows in listed(text) if "COMMAND [OPTIONS]" in text else []:
        for name, _ in rows:
            yield from command_sections(clothfit, [*words, name], level + 1)


def commands(clothfit):
    text = "# Commands\n\nWhat `clothfit help COMMAND` prints, of every command.\n\n"
    sections = ""
    for title, rows in listed(run(clothfit, "--help")):
        text += f"{title}\n\n"
        for name, description in rows:
            if name == "help":
                text += f"- `help`: {description}\n"
                continue
            text += f"- [{name}](#{name}): {description}\n"
            sections += "\n".join(command_sections(clothfit, [name], 2)) + "\n"
        text += "\n"
    return text + sections


def configuration(clothfit):
    """From the config.yaml of a simulation with nothing but defaults."""
    with tempfile.TemporaryDirectory() as folder:
        recording, out = pathlib.Path(folder) / "recording", pathlib.Path(folder) / "run"
        run(clothfit, "synthesize", "-o", str(recording), "--frames", "2")
        run(clothfit, "simulate", str(recording), "-o", str(out))
        lines = (out / "config.yaml").read_text().splitlines()
    text = (
        "# Configuration\n\n"
        "`--config FILE` changes how a recording is fitted. A file may name only what it changes; "
        "every run has the complete one as `config.yaml`. Here is every key with its default. "
        "Where a default depends on the recording, [what an option says](commands.md#fit) tells "
        "it.\n"
    )
    section = ""
    for line in lines:
        heading = re.fullmatch(r"(\w+):", line)
        key = re.fullmatch(r"  (\w+): (.*?)  # (.*)", line)
        if heading:
            section = heading.group(1)
            if section == "parameters":
                break
            text += f"\n## {section}\n\n| key | default | meaning |\n|---|---|---|\n"
        elif key and section:
            text += "| `{}` | `{}` | {} |\n".format(*(part.replace("|", "\\|") for part in key.groups()))
    return text + (
        "\n## parameters\n\nEach [parameter](terms.md) by its full name, with a number, its start, or "
        "a map:\n\n```yaml\nparameters:\n  air_drag.normal: 0.8\n"
        "  bending.stiffness: {value: 1e-4, free: false}\n```\n\n"
        "| key | meaning |\n|---|---|\n"
        "| `value` | where a fit starts, or the value where it is not free |\n"
        "| `free` | whether a fit estimates it |\n"
        "| `lower`, `upper` | bounds |\n"
        "| `prior`, `prior_sigma` | the prior's centre, and one sigma: a factor where the scale is "
        "logarithmic, an amount where it is linear |\n"
        "| `shared` | of a fit of several recordings: whether all have one value of it; else as its "
        "term says |\n"
    )


def number(value):
    return f"{value:g}" if isinstance(value, (int, float)) else str(value)


def parameter_table(parameters):
    text = "\n| parameter | unit | initial | off | bounds | scale | meaning |\n|---|---|---|---|---|---|---|\n"
    for p in parameters:
        free = " Free unless told otherwise." if p["free"] else ""
        text += (
            f"| `{p['name']}` | {p['unit']} | {number(p['initial'])} | {number(p['off'])} | "
            f"{number(p['lower'])} to {number(p['upper'])} | {p['scale']} | {p['doc']}.{free} |\n"
        )
    return text


def terms(clothfit):
    known = json.loads(run(clothfit, "terms", "--json"))
    text = (
        "# Terms and parameters\n\nEvery force term with its parameters, as `clothfit terms` has "
        "them. A parameter at its *off* value does nothing. [Model](../model.md) has the "
        "equations.\n\n## cloth\n\nWhat the cloth is.\n"
    )
    text += parameter_table(known["cloth"])
    for term in known["terms"]:
        kind = f"{term['role']}; {term['work']}; tied to {' and '.join(term['tied_to'])}"
        text += f"\n## {term['name']}\n\n{term['doc']} ({term['reference']}). {kind}.\n"
        text += parameter_table(term["parameters"])
    return text


def main():
    clothfit, out = sys.argv[1], pathlib.Path(sys.argv[2])
    out.mkdir(parents=True)
    for name, make in (("commands", commands), ("configuration", configuration), ("terms", terms)):
        (out / f"{name}.md").write_text(make(clothfit))


main()
