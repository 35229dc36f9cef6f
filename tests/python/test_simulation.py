# SPDX-License-Identifier: BSD-3-Clause
"""Runs from arrays."""

import subprocess
import sys

import numpy as np
import pytest
from conftest import SETTINGS, even_gas, sheared_gas

import sphk

SHOWN = ["Coordinates", "Velocities", "Masses", "Densities", "InternalEnergies", "Pressures", "Entropies"]


def write_gadget(path, gas):
    """The gas as an initial-condition file."""
    import h5py

    n, D = gas.position.shape
    with h5py.File(path, "w") as file:
        header = file.create_group("Header").attrs
        header.update({"BoxSize": gas.sides, "Time": 0.0, "NumPart_ThisFile": [n, 0, 0, 0, 0, 0], "Dimension": D})
        part = file.create_group("PartType0")
        for name, values in [("Coordinates", gas.position), ("Velocities", gas.velocity), ("Masses", gas.mass),
                             ("InternalEnergy", gas.u), ("ParticleIDs", np.arange(1, n + 1, dtype=np.uint64))]:
            part[name] = values


def test_gives_the_bits_of_the_command(folder):
    scene = sphk.scene("uniform", n=16, scheme="sph", end=0.05,
                       settings={"scene.dimension": 2, "scene.lattice": "random", "output.snapshots": 1})
    run = scene.run("by-command")
    sim = scene.simulation()
    sim.run()
    assert sim.time == run[-1].time == 0.05
    for name in SHOWN:
        told = run[-1][name]
        told = told[:, :2] if told.ndim == 2 else told
        if name != "Coordinates":  # files have them where readers look for them
            assert np.array_equal(sim.fields.by_id(name), told), name
    saved = sphk.load(sim.save("by-python"))
    for name in SHOWN:
        assert np.array_equal(saved[-1][name], run[-1][name]), name


def test_gives_the_bits_of_the_command_from_arrays(folder):
    gas = sheared_gas()
    write_gadget("ic.hdf5", gas)
    run = sphk.scene("ic.hdf5", end=0.05, settings={"output.snapshots": 1}, **SETTINGS).run("by-command")
    sim = sphk.Simulation(gas, **SETTINGS).run(until=0.05)
    for name in SHOWN[1:]:
        told = run[-1][name]
        assert np.array_equal(sim.fields.by_id(name), told[:, :2] if told.ndim == 2 else told), name


def test_a_saved_folder_is_one_of_the_command(folder):
    sim = sphk.Simulation(sheared_gas(), **SETTINGS)
    sim.run(until=0.04, every={0.02: lambda s: s.save("mine")})
    run = sphk.load("mine")
    assert run.times == [0, 0.02, 0.04] and len(run) == 3
    assert run.info["scheme"] == "sph" and run.info["particles"] == 256
    assert list(run.history["time"]) == run.times
    assert "mine" in subprocess.run([sphk.program.PROGRAM, "info", "mine/snap_0001.hdf5"], check=True, text=True,
                                    capture_output=True).stdout
    sim.close()
    with pytest.raises(sphk.InputError, match="--overwrite"):
        sphk.Simulation(sheared_gas(), **SETTINGS).save("mine")
    picture = run.plot()
    assert picture._repr_png_().startswith(b"\x89PNG")


def test_rows_are_those_of_their_ids():
    gas = even_gas(id=np.arange(1000, 1256)[::-1].copy())
    sim = sphk.Simulation(gas, **SETTINGS)
    ids = sim.fields.ids
    assert sorted(ids) == list(range(1000, 1256))
    assert np.array_equal(sim.fields["Coordinates"], gas.position[1255 - ids.astype(int)])
    assert np.array_equal(sim.fields.by_id("Coordinates"), gas.position[::-1])


def test_fields_are_views_of_the_run_in_given_units():
    sim = sphk.Simulation(sheared_gas(), units="given", steps="global", **SETTINGS)
    first, again = sim.fields["Velocities"], sim.fields["Velocities"]
    assert first.shape == (256, 2) and first.ctypes.data == again.ctypes.data and not first.flags.writeable
    kept = first.copy()
    sim.step()
    assert not np.array_equal(first, kept) and np.array_equal(first, sim.fields["Velocities"])
    assert np.from_dlpack(first).ctypes.data == first.ctypes.data
    own = sphk.Simulation(sheared_gas(), steps="global", **SETTINGS)
    apart = own.fields["Velocities"]
    kept = apart.copy()
    own.step()
    assert np.array_equal(apart, kept)
    assert np.allclose(own.fields.by_id("Velocities"), sim.fields.by_id("Velocities"), rtol=0, atol=1e-6)
    last = first.copy()
    sim.close()
    del sim, again
    assert np.array_equal(first, last)


def test_conserves_and_tells(capsys):
    sim = sphk.Simulation(sheared_gas(), **SETTINGS)
    start = sim.totals
    assert np.isclose(start["mass"], 1) and np.isclose(start["thermal_energy"], 1)
    sim.run(until=0.1, progress=True)
    assert "100" not in capsys.readouterr().out
    assert sim.time == 0.1 and np.isclose(sim.totals["total_energy"], start["total_energy"], rtol=1e-3)
    history = sim.history
    assert len(history["time"]) > 2 and np.all(np.diff(history["time"]) > 0) and history["total_energy"][0] > 1
    assert sim.costs["updates"] >= 256 * (len(history["time"]) - 1)
    rates = sim.rates()
    assert rates["Acceleration"].shape == (256, 2)
    assert np.abs((rates["Acceleration"] * sim.fields["Masses"][:, None]).sum(0)).max() < 1e-5
    assert set(sim.errors()) >= {"E0", "NearestNeighbour"}


def test_callbacks_come_at_multiples():
    times = []
    sim = sphk.Simulation(even_gas(time=0.01), **SETTINGS)
    sim.run(until=0.05, every={0.02: lambda s: times.append(s.time)})
    assert times == [0.02, 0.04] and sim.time == 0.05
    count = []
    sim.run(until=1, steps=3, every={10.0: count.append})
    assert sim.time < 1 and not count


@pytest.mark.parametrize("steps", ["global", "individual"])
def test_steps_without_an_end(steps):
    sim = sphk.Simulation(sheared_gas(), steps=steps, **SETTINGS)
    times = [sim.step()["time"] for _ in range(20)]
    assert np.all(np.diff([0, *times]) > 0) and len(sim.fields["Velocities"]) == 256


def test_gravity_as_a_source_term():
    """v = g t in a gas that falls as a whole; each step's share is added at its end."""
    g, end = np.array([0.3, -1.0]), 0.1
    sim = sphk.Simulation(even_gas(), **SETTINGS)
    sim.add_source(lambda s: {"acceleration": np.broadcast_to(g, (s.size, 2))})
    sim.run(until=end)
    assert np.allclose(sim.fields["Velocities"], g * end, rtol=0, atol=1e-5)
    assert np.isclose(sim.totals["heated"], 0.5 * g @ g * end**2, rtol=1e-3)
    assert sim.history["energy_drift"].max() < 1e-4


def test_cooling_as_a_source_term():
    """u' = -u/tau by steps of tau/100: (1 - 1/100)^k against exp(-k/100), k = 20."""
    tau = 0.5
    sim = sphk.Simulation(even_gas(u=1.0), **SETTINGS)
    sim.add_source(lambda s: {"du_dt": -s.fields["InternalEnergies"] / tau}, every=tau / 100)
    sim.run(until=20 * tau / 100)
    assert np.allclose(sim.fields["InternalEnergies"], 0.99**20, rtol=1e-5)
    assert abs(0.99**20 / np.exp(-0.2) - 1) < 20 / 100**2


def test_maps_hold_the_gas():
    """The mean over the map of a density in 2D is the mass; a map of x grows along x, one of y along y."""
    sim = sphk.Simulation(even_gas(), **SETTINGS)
    shown = sim.map("rho", pixels=32)
    assert shown.shape == (32, 32) and np.isclose(shown.mean(), 1, rtol=1e-3)
    x = sim.map(sim.fields["Coordinates"][:, 0], pixels=8, lower=(0.25, 0.25), upper=(0.75, 0.5))
    assert x.shape == (4, 8) and np.allclose(x, 0.25 + (np.arange(8) + 0.5) / 16, atol=0.02)


def test_heat():
    sim = sphk.Simulation(even_gas(), **SETTINGS)
    before = sim.fields.by_id("InternalEnergies").copy()
    sim.heat((0.03, 0.03), 0.5)
    gained = sim.fields.by_id("InternalEnergies") - before
    assert np.isclose(gained[0], 0.5 * 256, rtol=1e-5) and np.abs(gained[1:]).max() < 1e-3
    with pytest.raises(sphk.NumericsError, match="less than none"):
        sim.add(u=np.full(256, -1e6))


def test_ends_with_arrays_and_runs_alive():
    code = """
import numpy as np, sphk
x = sphk.ic.lattice(8, (1, 1))
gas = sphk.Particles(position=x, mass=1 / 64, u=1.0, box=(1, 1), periodic=True)
sims = [sphk.Simulation(gas, scheme="sph", units=units) for units in ("own", "given")]
arrays = [sim.fields["Velocities"] for sim in sims] + [sims[1].fields["Masses"]]
class Later:
    def __del__(self):
        print(arrays[2][0])
later = Later()
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "0.015625\n", "")
