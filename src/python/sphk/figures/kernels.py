# SPDX-License-Identifier: BSD-3-Clause
"""Smoothing kernels, their slopes and half-mass radii, as S12 Fig. 1."""

from .style import LINES, plt, save


def draw_kernels(kernels, path):
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 5.2), constrained_layout=True)
    for colour, kernel in zip(LINES, kernels):
        label = f"{kernel['name']}, half of the mass in {kernel['half_mass']:.3f} h"
        left.plot(kernel["q"], kernel["W"], color=colour, label=label)
        left.axvline(kernel["half_mass"], color=colour, lw=1, ls=":")
        right.plot(kernel["q"], kernel["dW"], color=colour)
    left.set(xlabel="$r/h$", ylabel="$W h^3$", xlim=(0, 1), ylim=(0, None))
    right.set(xlabel="$r/h$", ylabel=r"$h^4\,\partial W/\partial r$", xlim=(0, 1))
    left.legend()
    save(figure, path)
