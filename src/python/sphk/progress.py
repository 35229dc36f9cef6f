# SPDX-License-Identifier: BSD-3-Clause
"""How far a run is, in one line that is written again and again: in terminals and notebooks."""

import sys
import time


class Progress:
    """A bar on standard error, from `begin` to `end`; without one where `shown` is false."""

    interval = 0.25  # seconds between two lines

    def __init__(self, name, begin, end, shown):
        self.name, self.begin, self.end, self.shown = name, begin, end, shown
        self.started = time.monotonic()

    def show(self, now, updates):
        if not self.shown:
            return
        share = (now - self.begin) / (self.end - self.begin)
        spent = max(time.monotonic() - self.started, 1e-9)
        self._write(share, now, updates / spent, spent * (1 / share - 1) if share > 0 else 0)

    def end_line(self):
        if self.shown:
            sys.stderr.write("\n")
            sys.stderr.flush()

    def tell(self, now, end, speed, left):
        """The same of a run that says so much itself."""
        self.end = end
        if self.shown:
            self._write(now / end, now, speed, left)

    def _write(self, share, now, speed, left):
        bar = ("#" * round(24 * share)).ljust(24, ".")
        line = f"{self.name} {bar} t = {now:.4g} of {self.end:.4g}, {speed:.2g} updates/s, {left:.0f} s left"
        sys.stderr.write("\r" + line.ljust(100))
        sys.stderr.flush()
