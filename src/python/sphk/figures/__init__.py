# SPDX-License-Identifier: BSD-3-Clause
"""Figures, films and pages of sphk, drawn from numbers alone: nothing here needs the compiled part of the package.

`python -m sphk.figures` reads a work order (JSON) on standard input, as the command line writes it, and prints the
names of the files."""
