# SPDX-License-Identifier: BSD-3-Clause
"""What a run calls on its way."""

import math

import numpy as np

from . import _sphk


class Clock:
    """Calls at multiples of an interval."""

    def __init__(self, interval, call, time):
        if not interval > 0:
            raise _sphk.InputError(f"every: an interval of {interval} is no time; give positive ones, as in {{0.1: f}}")
        self.interval, self.call = interval, call
        self.count = math.ceil(time / interval - 1e-9)

    @property
    def next(self):
        return self.count * self.interval

    def is_due(self, time):
        if time < self.next - 1e-9 * self.interval:
            return False
        self.count += 1
        return True


class Source:
    """A source term, and until when it has acted."""

    def __init__(self, function, every, time):
        self.function, self.every, self.time = function, every, time

    @property
    def due(self):
        return math.inf if self.every is None else self.time + self.every

    def act(self, simulation):
        dt = simulation.time - self.time
        if self.every is not None and dt < self.every * (1 - 1e-9):
            return
        rates = dict(self.function(simulation))
        heating, acceleration = rates.pop("du_dt", None), rates.pop("acceleration", None)
        if rates:
            raise _sphk.InputError(f"a source term says {', '.join(map(str, rates))}; du_dt and acceleration are "
                                   "wanted")
        simulation.add(velocity=None if acceleration is None else dt * np.asarray(acceleration, float),
                       u=None if heating is None else dt * np.asarray(heating, float))
        self.time = simulation.time
