# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""What kills and soak share: how to go on with a run or diagnosis, and whether two folders are the same."""

import pathlib
import re

# The way to a result, not the result.
LOGS = {"log.txt"}

# Where a file tells seconds: by the file's name, what is put in their place.
TIMES = [
    # A number, or an object of stages; at any depth, any number of times.
    (r"\.json$", re.compile(rb'"seconds": *(?:\{[^{}]*\}|[-+.0-9eE]+)'), rb'"seconds": 0'),
    (r"^diagnosis\.md$", re.compile(rb"(?<=# Time\n).*?(?=\n#|\Z)", re.S), b""),
    # The last column.
    (r"^progress\.csv$", re.compile(rb",[^,\n]*$", re.M), b""),
    # CBOR: a string of 7 bytes, then a number of 8 or 4.
    (r"\.cbor$", re.compile(rb"\x67seconds(?:\xfb.{8}|\xfa.{4})", re.S), b"\x67seconds"),
]


def without_times(file):
    """The bytes of `file`, without the seconds that it tells."""
    content = file.read_bytes()
    for name, pattern, instead in TIMES:
        if re.search(name, file.name):
            content = pattern.sub(instead, content)
    return content


def files_of(folder):
    """Paths of all files in `folder`, at any depth, relative to it."""
    return {file.relative_to(folder) for file in folder.rglob("*") if not file.is_dir()}


def differences(folder, other, ignored=()):
    """Names of the files, sorted, that differ or that one of the folders does not have."""
    folder, other = pathlib.Path(folder), pathlib.Path(other)
    there, here = files_of(folder), files_of(other)
    return sorted(
        str(file)
        for file in there | here
        if file.name not in LOGS
        and str(file) not in ignored
        and (
            file not in there
            or file not in here
            or without_times(folder / file) != without_times(other / file)
        )
    )


def resume_command(command, folder):
    """What goes on with `command` (words without -o) in `folder` (a path, absolute).

    From the beginning where a fit was ended before anything was written.
    """
    if command[0] == "diagnose":
        return [*command, "-o", str(folder), "--resume"]
    if (folder / "config.yaml").exists():
        return ["fit", "--resume", "-o", str(folder), "--quiet"]
    return [*command, "-o", str(folder), "--force"]
