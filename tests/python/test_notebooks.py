# SPDX-License-Identifier: BSD-3-Clause
"""Notebooks run as they stand."""

import os
from pathlib import Path

import pytest

NOTEBOOKS = Path(os.environ.get("SPHK_NOTEBOOKS", "."))


@pytest.mark.parametrize("notebook", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_notebook(notebook, tmp_path):
    nbformat, nbconvert = pytest.importorskip("nbformat"), pytest.importorskip("nbconvert.preprocessors")
    book = nbformat.read(notebook, as_version=4)
    nbconvert.ExecutePreprocessor(timeout=240).preprocess(book, {"metadata": {"path": str(tmp_path)}})
