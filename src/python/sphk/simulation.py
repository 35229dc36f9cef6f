# SPDX-License-Identifier: BSD-3-Clause
"""A simulation in progress."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _sphk
from .calls import Clock, Source
from .fields import Fields
from .keys import key_texts, table
from .particles import Particles
from .progress import Progress

_FOREVER = 1e30  # seconds


class Simulation:
    """A run of gas under a scheme.

    gas         Particles
    scheme      sphk.scheme_names() or a paper's label, such as "SPHS-HCT442"; sph where left out
    kernel      sphk.kernel_names(); the scheme's own where left out
    neighbours  inside a support radius; as many as the kernel wants where left out
    gamma       of the equation of state
    precision   of the pairs: "mixed" (float) or "double"
    courant     number of the time-step
    energy      "entropy" or "energy": the thermal variable that is integrated
    steps       "individual" or "global": of the particles' own, or one for all
    threads     on the CPU: those of the first simulation of a process hold for all
    units       "own": the run computes in units that suit the gas, powers of two of the given ones, as `sphk run` does;
                "given": in the given ones, so that fields are views of its memory
    settings    further keys, such as {"viscosity.alpha": 1}

    InputError where something does not go together, DeviceError where memory is short."""

    def __init__(self, gas: Particles, *, scheme: str | None = None, kernel: str | None = None,
                 neighbours: float | None = None, gamma: float | None = None, precision: str | None = None,
                 courant: float | None = None, energy: str | None = None, steps: str | None = None,
                 threads: int | None = None, units: str = "own", settings: Mapping[str, Any] | None = None):
        given = {"sph.scheme": scheme, "sph.kernel": kernel, "sph.neighbours": neighbours, "sph.gamma": gamma,
                 "sph.precision": precision, "time.courant": courant, "sph.energy": energy, "time.steps": steps}
        self._start(_sphk.run_of_gas, gas._gas(), given, threads, units, settings)

    def _start(self, make, what, given, threads, units, settings):
        if units not in ("own", "given"):
            raise _sphk.InputError(f'units={units!r}: "own" or "given" is wanted')
        self._run = make(what, key_texts(given, settings), int(threads or 0), units == "given")
        self._sources = []
        self._heatings = self._run.heatings
        self.folder = None

    @classmethod
    def _of_scene(cls, what, keys, threads, units):
        simulation = cls.__new__(cls)
        simulation._start(_sphk.run_of_scene, what, keys, threads, units, None)
        return simulation

    def __repr__(self):
        keys = self.settings
        return (f"<sphk.Simulation: {self.size} particles in {self._run.dimension}D, {keys['sph.scheme']}, "
                f"{keys['sph.kernel']}, {keys['sph.neighbours']:g} neighbours, t = {self.time:.6g}>")

    # What it is and how far it is

    @property
    def time(self) -> float:
        """Of the gas, in its units."""
        return self._run.time

    @property
    def size(self) -> int:
        """Number of particles."""
        return self._run.size

    @property
    def box(self) -> dict[str, tuple]:
        """lower, size and periodic, each a tuple of D."""
        return self._run.box

    @property
    def settings(self) -> dict[str, Any]:
        """Every key of the run, with its value."""
        return self._run.settings()

    @property
    def warnings(self) -> list[str]:
        """Sentences on what is to be known of this gas under these settings."""
        return self._run.warnings

    @property
    def totals(self) -> dict[str, Any]:
        """Sums over all particles, now: mass, energies, momentum (D,), angular_momentum (3,), extremes of rho and P."""
        return self._run.totals()

    @property
    def costs(self) -> dict[str, Any]:
        """Since the start: updates, pair interactions, flops, bytes a particle, seconds by the phase of a step."""
        return self._run.costs()

    @property
    def history(self) -> Any:
        """Rows of sums, their drift and extremes over time, the columns of history.csv: a DataFrame where pandas is
        installed, else a dict of arrays. There is a row at the start, at every stop of run(), after every step() and
        whenever all particles have been computed since the last one."""
        return table(self._run.history())

    @property
    def fields(self) -> Fields:
        """The gas now, a mapping of names to arrays; see Fields."""
        return Fields(self._run)

    def rates(self, split: bool = False) -> dict[str, NDArray]:
        """One right-hand side at the present state, by name, rows as in `fields`: Acceleration (N, D), EntropyRate,
        Density, NeighbourCount and so on; with `split` each term apart as well."""
        return self._run.rates(split)

    def errors(self) -> dict[str, NDArray]:
        """Leading errors of the scheme's sums at the present state, by name: E0 (N, D), R and V (N, 6), ..."""
        return self._run.errors()

    def map(self, field: str | ArrayLike = "rho", pixels: int = 512, *, z: float | None = None,
            lower: Sequence[float] | None = None, upper: Sequence[float] | None = None) -> NDArray:
        """The gas on a grid: rows of pixels from the bottom up, `pixels` along x and as many along y as make them
        square, in 2D and 3D. In 3D the integral along z, or the slice at height z. NaN where a slice meets no gas.

        field         a name of `fields`, such as rho, or (N,) numbers, rows as in `fields`
        lower, upper  corners of what is seen, (x, y); the box where left out"""
        box, fields = self.box, self.fields
        corner = np.array(box["lower"][:2] if lower is None else lower, float)
        side = np.array(np.add(box["lower"], box["size"])[:2] if upper is None else upper, float) - corner
        places = np.zeros((self.size, 3))
        places[:, :self._run.dimension] = fields["Coordinates"]
        value = np.ascontiguousarray(fields[field] if isinstance(field, str) else field, float)
        shape = (int(pixels), max(1, round(pixels * side[1] / side[0])))
        return _sphk.map(places, fields["Masses"] / fields["Densities"], value, box["lower"], box["size"],
                         box["periodic"], corner.tolist(), side.tolist(), shape, z)

    # What changes it

    def step(self, t_end: float | None = None) -> dict[str, Any]:
        """One time-step, which does not pass `t_end`. Returns step, time, dt, updates, neighbours (least, mean, most)
        and limiting_id, the particle that set dt. NumericsError where the numbers go wrong."""
        end = self._horizon() if t_end is None else self._end(t_end, "t_end")
        self._heat_as_the_scene()
        report = self._run.step(min([end, *self._heating_times(end)]))
        self._act()
        return report

    def run(self, until: float | None = None, *, every: Mapping[float, Callable[[Simulation], Any]] | None = None,
            steps: int | None = None, progress: bool = False) -> Simulation:
        """Steps until a time (the scene's own end where it is left out), or so many steps at most.

        every     {interval: function}: called with the simulation, at the start if that is a multiple of the interval,
                  and at every multiple until the end. The steps end there.
        progress  True: a bar on standard error

        Other Python threads run meanwhile. KeyboardInterrupt ends it after the step that it comes in: the simulation is
        whole then, and goes on with another run(). NumericsError where the numbers go wrong. Returns the simulation."""
        end = self._end(until, "until")
        clocks = [Clock(interval, call, self.time) for interval, call in (every or {}).items()]
        bar = Progress(self.settings["sph.scheme"], self.time, end, progress)
        updates, left = self.costs["updates"], -1 if steps is None else int(steps)
        taken = self._run.step_count
        try:
            self._call(clocks)
            while self.time < end and left != 0:
                self._heat_as_the_scene()
                stop = min([end, *(clock.next for clock in clocks), *self._heating_times(end)])
                self._advance(stop, left)
                left = -1 if steps is None else max(0, int(steps) - (self._run.step_count - taken))
                bar.show(self.time, self.costs["updates"] - updates)
                if self.time >= stop:
                    self._call(clocks)
        finally:
            self._run.note()
            bar.end_line()
        return self

    def heat(self, place: Sequence[float], energy: float) -> None:
        """Adds energy to the particle nearest to a place (D numbers), at once."""
        self._run.heat([float(x) for x in place], float(energy))

    def add(self, *, velocity: ArrayLike | None = None, u: ArrayLike | None = None) -> None:
        """Adds to velocities (N, D) and to thermal energies a mass (N,), at once; rows as in `fields`. All steps end
        there, and it costs one more right-hand side of all particles. NumericsError where u would fall below zero."""
        n, dimension = self.size, self._run.dimension
        self._run.add(_gain("velocity", velocity, (n, dimension)), _gain("u", u, (n,)))

    def add_source(self, function: Callable[[Simulation], Mapping[str, ArrayLike]], every: float | None = None) -> None:
        """A source term: `function(sim)` returns a dict with "du_dt" (N,), thermal energy a mass and time, or
        "acceleration" (N, D), or both, rows as in sim.fields. By operator splitting: what it says at the end of a step,
        or of an interval `every`, is added for the time that has passed, an error of first order in that time. Each
        time it costs one more right-hand side of all particles, whose steps all end there: `every` so many steps is
        cheaper."""
        self._sources.append(Source(function, every, self.time))

    # What it leaves

    def save(self, folder: str | PathLike, overwrite: bool = False) -> Path:
        """Writes the state as a snapshot, with history.csv, run.json and scene.used.toml, into a folder as of `sphk
        run`, which `sphk plot` and sphk.load() open. Saved there again, later states join it. Returns its path."""
        self.folder = self._run.save(folder, overwrite)
        return self.folder

    def close(self) -> None:
        """Lets go of its memory. Arrays of it stay."""
        self._run.close()

    # Its own business

    def _end(self, until, name):
        end = self.settings["time.end"] if until is None else float(until)
        if not math.isfinite(end) or end <= self.time:
            raise _sphk.InputError(f"{name} = {until}: a time after t = {self.time:g} is wanted")
        return end

    def _horizon(self):
        """A time that steps need not end at, but to which hierarchies of steps are made: a multiple of what sound takes
        through the box."""
        now, gamma = self.totals, self.settings["sph.gamma"]
        speed = now["max_speed"] + math.sqrt(gamma * now["max_P"] / now["min_rho"])
        crossing = 2.0 ** round(math.log2(max(self.box["size"]) / speed)) if speed > 0 else 1.0
        return (math.floor(self.time / crossing * (1 + 1e-12)) + 1) * crossing

    def _heating_times(self, end):
        return [time for time, _, _ in self._heatings if time < end]

    def _heat_as_the_scene(self):
        while self._heatings and self._heatings[0][0] <= self.time:
            _, place, energy = self._heatings.pop(0)
            self.heat(place, energy)

    def _call(self, clocks):
        for clock in clocks:
            if clock.is_due(self.time):
                self._run.note()
                clock.call(self)

    def _advance(self, stop, left):
        """Some steps, no more than `left` (-1: any number), for about as long as a bar stands still."""
        if not self._sources:
            self._run.advance(stop, left, Progress.interval)
            return
        stop = min([stop, *(source.due for source in self._sources)])
        self._run.advance(stop, 1, _FOREVER)
        self._act()

    def _act(self):
        for source in self._sources:
            source.act(self)


def _gain(name, values, shape):
    if values is None:
        return None
    array = np.asarray(values, float)
    if array.shape != shape and array.shape != shape[1:]:
        raise _sphk.InputError(f"{name}: its shape is {array.shape}; {shape}, rows as in fields, is wanted")
    return np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)
