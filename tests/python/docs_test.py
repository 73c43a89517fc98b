# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""The code in python/README.md runs as it stands, but for what needs PyTorch or JAX."""
import os
import pathlib
import re

ROOT = pathlib.Path(__file__).parents[2]


def test_the_code_of_the_page_runs(tmp_path):
    page = (ROOT / "python" / "README.md").read_text()
    blocks = re.findall(r"(<!-- not run: \w+ -->\n)?```python\n(.*?)```", page, re.DOTALL)
    assert sum(1 for skipped, _ in blocks if skipped) == 2
    (tmp_path / "data").symlink_to(ROOT / "data")
    names = {}
    before = os.getcwd()
    os.chdir(tmp_path)
    try:
        for skipped, code in blocks:
            compile(code, "python/README.md", "exec")
            if not skipped:
                exec(code, names)
    finally:
        os.chdir(before)
    assert (tmp_path / "runs" / "lift.html").stat().st_size > 100_000
    assert blocks[0][1].count("\n") <= 11  # ten lines and a blank one
    assert names["run"].status == "converged"
