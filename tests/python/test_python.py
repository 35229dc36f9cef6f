# SPDX-License-Identifier: BSD-3-Clause
"""What is Python's own: errors, signals, threads, names."""

import os
import signal
import subprocess
import sys
import sysconfig
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import SETTINGS, even_gas, sheared_gas

import sphk


@pytest.mark.parametrize("wrong, sentence", [
    ({"mass": np.ones(3)}, "mass: its shape is (3,); (4,)"),
    ({"velocity": np.ones((4, 3))}, "velocity: its shape is (4, 3); (4, 2)"),
    ({"position": np.ones((4, 2, 2))}, "position: its shape is (4, 2, 2)"),
    ({"box": (1, 1, 1)}, "box = (1, 1, 1): 2 sides"),
    ({"periodic": (True,) * 3}, "periodic: its shape is (3,)"),
    ({"id": np.ones(4)}, "id: float64"),
    ({"u": "hot"}, "u: numbers are wanted"),
])
def test_arrays_of_other_shapes(wrong, sentence):
    right = {"position": np.random.default_rng(1).random((4, 2)), "mass": 1.0, "u": 1.0, "box": (1, 1)}
    with pytest.raises(sphk.InputError) as caught:
        sphk.Particles(**{**right, **wrong})
    assert sentence in str(caught.value) and isinstance(caught.value, ValueError)


@pytest.mark.parametrize("wrong, sentence", [
    ({"scheme": "spg"}, "sph"),
    ({"kernel": "wc22"}, "wc2"),
    ({"settings": {"viscosity.alhpa": 1}}, "viscosity.alpha"),
    ({"units": "cgs"}, '"own" or "given"'),
    ({"neighbours": -1}, "neighbours"),
])
def test_settings_that_are_not_there(wrong, sentence):
    with pytest.raises(sphk.InputError) as caught:
        sphk.Simulation(even_gas(), **{**SETTINGS, **wrong})
    assert sentence in str(caught.value)


def test_gas_that_cannot_run():
    gas = even_gas()
    gas.u = gas.u.copy()
    gas.u[7] = np.nan
    with pytest.raises(sphk.InputError, match="8"):
        sphk.Simulation(gas, **SETTINGS)
    sim = sphk.Simulation(even_gas(), **SETTINGS)
    with pytest.raises(sphk.InputError, match="after t = 0"):
        sim.run()
    with pytest.raises(KeyError, match="Velocities"):
        sim.fields["Velocitys"]
    with pytest.raises(sphk.InputError, match="du_dt and acceleration"):
        sim.add_source(lambda s: {"heating": 1})
        sim.step()
    sim.close()
    with pytest.raises(sphk.InputError, match="closed"):
        sim.step()


def test_interrupts_end_a_run_between_steps():
    sim = sphk.Simulation(sheared_gas(32), **SETTINGS)
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        sim.run(until=1e3)
    reached = sim.time
    assert 0 < reached < 1e3
    sim.run(until=reached + 0.01)
    assert np.isclose(sim.totals["mass"], 1)


def test_other_threads_go_on():
    sims = [sphk.Simulation(sheared_gas(24), **SETTINGS) for _ in range(2)]
    alone = sphk.Simulation(sheared_gas(24), **SETTINGS).run(until=0.05)
    threads = [threading.Thread(target=sim.run, args=(0.05,)) for sim in sims]
    for thread in threads:
        thread.start()
    turns = 0
    while any(thread.is_alive() for thread in threads):
        time.sleep(0.001)
        turns += 1
    assert turns > 2  # a thread that kept the interpreter would let none through
    for sim in sims:
        assert np.array_equal(sim.fields.by_id("Velocities"), alone.fields.by_id("Velocities"))


def test_number_of_threads_is_that_of_the_process():
    running = int(os.environ["OMP_NUM_THREADS"])
    sphk.Simulation(even_gas(), threads=running, **SETTINGS)
    with pytest.raises(sphk.InputError, match="start Python anew"):
        sphk.Simulation(even_gas(), threads=running + 1, **SETTINGS)


def test_the_command():
    command = Path(sysconfig.get_path("scripts")) / "sphk"
    done = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    assert sphk.__version__ in done.stdout
    done = subprocess.run([command, "run", "sodd"], capture_output=True, text=True)
    assert done.returncode == 2 and "sod" in done.stderr


def test_types_are_told():
    package = Path(sphk.__file__).parent
    assert (package / "py.typed").exists()
    stub = (package / "_sphk.pyi").read_text()
    for name in ["class Run", "def arranged", "class InputError"]:
        assert name in stub
    for public in [getattr(sphk, name) for name in sphk.__all__] + list(vars(sphk.ic).values()):
        if getattr(public, "__module__", "").startswith("sphk") and not public.__name__.startswith("_"):
            assert public.__doc__, public


def test_figures_need_no_engine():
    code = "import sphk, sys; sphk.__version__; print([name for name in sys.modules if name in ('matplotlib', 'h5py')])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"
