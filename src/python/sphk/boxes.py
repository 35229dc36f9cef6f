# SPDX-License-Identifier: BSD-3-Clause
"""Boxes, as users give them."""

import numpy as np

from . import _sphk


def corner_and_sides(box, dimension=None):
    """The lower corner and the sides of a box, as lists of D numbers: of D sides, or of two corners of D numbers."""
    try:
        array = np.atleast_1d(np.asarray(box, float))
    except (TypeError, ValueError):
        array = np.empty(0)
    D = dimension or array.shape[-1]
    if array.shape == (2, D) and array.ndim == 2:
        return array[0].tolist(), (array[1] - array[0]).tolist()
    if array.shape != (D,) or D not in (1, 2, 3):
        sides = D if D in (1, 2, 3) else "one to three"
        raise _sphk.InputError(f"box = {box}: {sides} sides, as in box=(1, 1), or two corners, as in "
                               "box=((-1, -1), (1, 1)), are wanted, as many numbers as there are dimensions")
    return [0.0] * D, array.tolist()
