# SPDX-License-Identifier: BSD-3-Clause
"""The command `sphk`: the program of the package takes this process over."""

import os
import sys

from .program import PROGRAM, environment


def main():
    os.execve(PROGRAM, ["sphk", *sys.argv[1:]], environment())
