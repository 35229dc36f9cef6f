# SPDX-License-Identifier: BSD-3-Clause
"""Smoothed-particle hydrodynamics for compressible gas.

    gas = sphk.Particles(position=xy, mass=m, u=u, velocity=v, box=(1, 1), periodic=True)
    sim = sphk.Simulation(gas, scheme="sphs", kernel="wc6", neighbours=100, gamma=5/3)
    sim.run(until=2.0, every={0.05: watch})
    sphk.scene("sod", n=64).run().plot(exact=True)

Numbers are in any one system of units; N particles in D dimensions are arrays of shapes (N,) and (N, D)."""

import importlib

# What the package offers, by the module that has it, which is loaded when it is asked for: figures need no engine.
_OFFERED = {
    "_sphk": ["DeviceError", "InputError", "NumericsError", "__version__", "kernel_names", "scheme_names"],
    "figures": [],
    "folder": ["Run", "load"],
    "films": ["movie"],
    "ic": [],
    "particles": ["Particles"],
    "program": ["study"],
    "scenes": ["Scene", "scene"],
    "simulation": ["Simulation"],
}
_OWNERS = {name: module for module, names in _OFFERED.items() for name in names}
__all__ = [*(name for name in _OWNERS if not name.startswith("_")), "ic"]


def __getattr__(name):
    if name in _OFFERED:
        return importlib.import_module("." + name, __name__)
    if name in _OWNERS:
        return getattr(importlib.import_module("." + _OWNERS[name], __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted([*globals(), *__all__])
