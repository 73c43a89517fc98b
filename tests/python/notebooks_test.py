# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""The notebooks run from the first cell to the last."""
import pathlib

import pytest

nbformat = pytest.importorskip("nbformat", reason="python3-nbconvert is not installed")
preprocessors = pytest.importorskip(
    "nbconvert.preprocessors", reason="python3-nbconvert is not installed"
)
pytest.importorskip("ipykernel", reason="python3-ipykernel is not installed")
pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")

ROOT = pathlib.Path(__file__).parents[2]


@pytest.mark.parametrize("name", ["fit", "diagnosis"])
def test_runs(name, monkeypatch):
    monkeypatch.setenv("CLOTHFIT_DATA", str(ROOT / "data"))
    notebook = nbformat.read(ROOT / "python" / "notebooks" / f"{name}.ipynb", as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert len(cells) > 3 and not any(cell.outputs for cell in cells)  # kept without results
    executor = preprocessors.ExecutePreprocessor(timeout=600, kernel_name="python3")
    executor.preprocess(notebook, {"metadata": {"path": str(ROOT)}})
    pictures = [o for cell in cells for o in cell.outputs if "image/png" in o.get("data", {})]
    assert pictures
