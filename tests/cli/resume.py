# SPDX-License-Identifier: BSD-3-Clause
"""A run that is stopped or killed and gone on with gives what it would have given. Usage: resume.py SPHK."""

import glob
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import h5py
except ImportError:
    print("skipped: comparing snapshots needs python3-h5py")
    sys.exit(77)

SPHK = sys.argv.pop()
KILLS = 50
SEED = 20261126


def datasets(path):
    """Every dataset of a snapshot's gas, as bytes."""
    with h5py.File(path, "r") as file:
        return {name: (data.dtype.str, data.shape, data[...].tobytes()) for name, data in file["PartType0"].items()}


class Resume(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name

    def tearDown(self):
        self.temporary.cleanup()

    def sphk(self, *arguments, code=0):
        done = subprocess.run([SPHK, *arguments], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def start(self, *arguments):
        return subprocess.Popen([SPHK, *arguments], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def assert_same(self, one, other):
        with open(self.path(one, "history.csv"), "rb") as a, open(self.path(other, "history.csv"), "rb") as b:
            self.assertEqual(a.read(), b.read())
        names = [os.path.basename(name) for name in sorted(glob.glob(self.path(one, "snap_*.hdf5")))]
        self.assertEqual(names, [os.path.basename(name) for name in sorted(glob.glob(self.path(other, "snap_*.hdf5")))])
        for name in names:
            self.assertTrue(datasets(self.path(one, name)) == datasets(self.path(other, name)), name)
        with open(self.path(one, "run.hdf.series"), "rb") as a, open(self.path(other, "run.hdf.series"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_runs_of_all_kinds_go_on_bit_by_bit(self):
        self.sphk("run", "uniform", "-n", "8", "--set", "scene.lattice=cubic", "--set", "scene.jitter=0.3", "--steps", "1",
                  "--out", "gas")
        runs = {
            "individual": ["sod", "-n", "16", "--scheme", "sphs", "--set", "scene.across=4", "--t-end", "0.1"],
            "multi": ["sod-multimass", "-n", "16", "--set", "scene.across=4", "--set", "scene.lattice=cubic"],
            "energy": ["kh12", "-n", "16", "--set", "scene.dimension=2", "--set", "scene.edges=soft", "--t-end", "2"],
            "measures": ["mcnally", "-n", "16", "--t-end", "0.8", "--set", "output.errors=true"],
            "open": ["noh", "-n", "12", "--set", "scene.dimension=2", "--scheme", "osph"],
            "conductivity": ["shearing", "-n", "20", "--t-end", "0.05"],
            "file": ["gas/snap_0001.hdf5", "--scheme", "gadget2", "--t-end", "0.5"],
        }
        for name, words in runs.items():
            with self.subTest(name):
                words = [*words, "--set", "output.snapshots=4"]
                begin = time.monotonic()
                self.sphk("run", *words, "--out", name)
                tenth = max(0.15, (time.monotonic() - begin) / 10)
                text = self.sphk("run", *words, "--out", name + "-2", "--walltime", "0.001", code=75)
                self.assertIn("sphk run --resume " + name + "-2", text)
                for walltime in ("0.001", "0.001", "0.001"):  # a step each
                    self.sphk("run", "--resume", name + "-2", "--walltime", walltime, code=75)
                code = 75
                while code == 75:
                    done = subprocess.run([SPHK, "run", "--resume", name + "-2", "--walltime", str(tenth)],
                                          cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                    code = done.returncode
                self.assertEqual(code, 0, done.stdout)
                self.assert_same(name, name + "-2")
                self.assertEqual(glob.glob(self.path(name + "-2", "checkpoint*")), [], "a complete run needs none")

    def test_a_killed_run_goes_on_from_its_newest_checkpoint(self):
        run = ["sod", "-n", "32", "--set", "scene.across=8", "--set", "output.snapshots=20", "--t-end", "0.2"]
        self.sphk("run", *run, "--out", "whole")
        rng = random.Random(SEED)
        self.start_killed(rng, "run", *run, "--set", "output.checkpoint=0.005", "--out", "killed")
        kills = 1
        while kills < KILLS:
            if not glob.glob(self.path("killed", "checkpoint*")):  # it came to its end, or not to its first checkpoint
                complete = os.path.exists(self.path("killed", "run.json"))
                if complete:
                    self.assert_same("whole", "killed")
                kills += self.start_killed(rng, "run", *run, "--set", "output.checkpoint=0.005", "--out", "killed",
                                           "--overwrite")
                continue
            kills += self.start_killed(rng, "run", "--resume", "killed")
        if glob.glob(self.path("killed", "checkpoint*")):
            self.sphk("run", "--resume", "killed")
        else:
            self.sphk("run", *run, "--set", "output.checkpoint=0.005", "--out", "killed", "--overwrite")
        self.assert_same("whole", "killed")

    def start_killed(self, rng, *arguments):
        """Whether it was killed; else it had come to its end."""
        running = self.start(*arguments)
        time.sleep(0.05 + 0.35 * rng.random())
        running.kill()
        text = running.communicate()[0]
        self.assertIn(running.returncode, (0, -signal.SIGKILL), text)
        return running.returncode != 0

    def test_signals_and_the_stop_file(self):
        run = ["run", "sod", "-n", "64", "--scheme", "sphs", "--set", "scene.across=8"]
        for k, stop in enumerate((signal.SIGTERM, signal.SIGINT, signal.SIGUSR1, None)):
            out = f"stopped-{k}"
            running = self.start(*run, "--out", out)
            while running.poll() is None and not os.path.exists(self.path(out, "snap_0000.hdf5")):
                time.sleep(0.005)
            if stop:
                running.send_signal(stop)
            else:
                open(self.path(out, "stop"), "w", encoding="utf-8").close()
            text = running.communicate()[0]
            self.assertEqual(running.returncode, 75, text)
            self.assertRegex(text, r"go on with: \S*sphk run --resume " + out)
            self.assertTrue(os.path.exists(self.path(out, "checkpoint_a.hdf5")))
        running = self.start(*run, "--out", "goes-on")
        while running.poll() is None and not os.path.exists(self.path("goes-on", "snap_0000.hdf5")):
            time.sleep(0.005)
        running.send_signal(signal.SIGUSR2)
        while running.poll() is None and not os.path.exists(self.path("goes-on", "checkpoint_a.hdf5")):
            time.sleep(0.005)
        self.assertTrue(os.path.exists(self.path("goes-on", "checkpoint_a.hdf5")))
        self.assertIsNone(running.poll(), "SIGUSR2 does not end it")
        running.terminate()
        running.communicate()

    def test_what_cannot_be_resumed_is_said(self):
        self.assertIn("holds no run", self.sphk("run", "--resume", "nowhere", code=2))
        self.sphk("run", "sod", "-n", "16", "--set", "scene.dimension=1", "--out", "complete")
        self.assertIn("holds no checkpoint", self.sphk("run", "--resume", "complete", code=2))
        self.assertIn("as it is", self.sphk("run", "--resume", "complete", "--kernel", "cs", code=2))
        self.assertIn("--walltime 1h", self.sphk("run", "sod", "--walltime", "1h", code=2))
        self.assertIn("--resume DIR", self.sphk("run", code=2))


unittest.main()
