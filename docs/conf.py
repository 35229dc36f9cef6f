# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx: pages in MyST, what the program tells of itself, and the C++ interface by way of Doxygen.

    pip install -r docs/requirements.txt         # and doxygen, from your system
    SPHK_PROGRAM=build/openmp/bin/sphk sphinx-build -W -n docs build/docs
"""

import os
import re
import subprocess
import sys
from pathlib import Path

docs = Path(__file__).resolve().parent
sys.path.insert(0, str(docs))
sys.dont_write_bytecode = True
import generate  # noqa: E402

project, author, copyright = "sphk", "The sphk authors", "The sphk authors"
version = release = re.search(r"project\(sphk VERSION ([\d.]+)", (docs.parent / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe", "sphinx_copybutton", "sphinx-mathjax-offline"]
myst_enable_extensions = ["dollarmath", "amsmath", "deflist", "attrs_block"]
myst_heading_anchors = 3
exclude_patterns = ["examples", "requirements.txt"]
html_theme = "furo"
html_title = f"sphk {version}"
html_static_path = ["static"]
html_css_files = ["pages.css"]
html_theme_options = {"navigation_with_keys": False}
smartquotes = False  # they would join the hyphens of --options
copybutton_prompt_text = "$ "
# Types of the standard library, of Kokkos and of numpy have no page here.
nitpick_ignore_regex = [(r"cpp:.*", r".*"), (r"py:.*", r".*")]
sys.path.insert(0, str(generate.PYTHON))
autodoc_mock_imports = ["sphk._sphk"]  # what is compiled
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings have shapes and units
default_role = "literal"  # of `words` in docstrings


breathe_default_project = "sphk"
breathe_default_members = ("members",)
breathe_domain_by_extension = {"hpp": "cpp"}
breathe_show_include = False


def fill_in(app, page, source):
    """Puts what the program tells in the place of `% generated: NAME`."""
    source[0] = re.sub(r"^% generated: (\w+)$", lambda line: generate.PAGES[line[1]](), source[0], flags=re.MULTILINE)


def list_arguments(app, what, name, thing, options, lines):
    """Makes lists of docstrings' paragraphs that are "name    meaning" by line, with further lines indented."""
    texts = "\n".join(lines).replace("*", "\\*").split("\n\n")
    for k, text in enumerate(texts):
        rows = re.split(r"\n(?=\S)", text)
        found = [re.fullmatch(r"(\S+(?: \S+)*) {2,}(\S.*)", row, re.DOTALL) for row in rows]
        if all(found):
            texts[k] = "\n".join(f"``{row[1]}``\n    {' '.join(row[2].split())}" for row in found)
    lines[:] = "\n\n".join(texts).split("\n")


def read_headers(app, config):
    """Has Doxygen write the XML of the public headers, beside Sphinx' own notes of a build."""
    folder = Path(app.doctreedir) / "doxygen"
    folder.mkdir(parents=True, exist_ok=True)
    settings = (docs / "api" / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder}\n"
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=docs.parent, check=True, stdout=subprocess.DEVNULL)
    config.breathe_projects = {"sphk": str(folder / "xml")}


def setup(app):
    os.environ.setdefault("SPHK_PROGRAM", "sphk")
    app.connect("config-inited", read_headers)
    app.connect("source-read", fill_in)
    app.connect("autodoc-process-docstring", list_arguments)
