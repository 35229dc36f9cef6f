# SPDX-License-Identifier: BSD-3-Clause
"""What today's readers show of our snapshots by their default calls: numbers, slices and projections.
Usage: readers.py SPHK ENVIRONMENT"""

import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
import pip_environment

# numpy: yt 4.4.3 turns SWIFT's one-element attributes into numbers in a way that newer ones refuse.
PACKAGES = ["yt", "swiftsimio", "pynbody", "vtk", "h5py", "numpy<2.4"]

if sys.argv[-1] != "within":
    pip_environment.run_within(sys.argv[2], PACKAGES, [*sys.argv, "within"])

try:
    import numpy as np
    from runs import RUNS, check_rates, make
    from with_pynbody import check_pynbody
    from with_swiftsimio import check_swiftsimio
    from with_vtk import check_series, check_vtk
    from with_yt import check_yt
except ImportError as error:  # a library of the system that one of them wants
    print(f"skipped: a reader does not load here: {error}")
    sys.exit(pip_environment.SKIPPED)


def main():
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for name in RUNS:
            truth = make(sys.argv[1], Path(folder), name)
            for check in [check_rates, check_vtk, check_series, check_yt, check_swiftsimio, check_pynbody]:
                try:
                    check(truth)
                    print(f"{name}: {check.__name__} passed", flush=True)
                except Exception as error:  # of the readers, too: tell all of them
                    failed.append(f"{name}: {check.__name__}: {type(error).__name__}: {error}")
                    print(failed[-1], flush=True)
    sys.exit(len(failed) > 0)


np.seterr(all="ignore")
main()
