# SPDX-License-Identifier: BSD-3-Clause
"""Figures of any field; streams and files of studies. Usage: fields.py SPHK; exit code 77: no matplotlib."""

import datetime
import json
import os
import shlex
import socket
import subprocess
import unittest

from figures import SPHK, WithRun, colours, share  # first: it tells where matplotlib is missing
import matplotlib.image


class Fields(WithRun):
    def test_any_field_is_a_map_and_what_is_none_is_refused(self):
        self.assertEqual(self.sphk("plot", "run", "--field", "v_y", "--range", "-0.5,0.5").split(),
                         ["run/snap_0001_map_v_y.png"])
        pixels = colours(os.path.join(self.folder, "run", "snap_0001_map_v_y.png"))[0]
        red, blue = (pixels[:, 0] - pixels[:, 2] > 0.2).mean(), (pixels[:, 2] - pixels[:, 0] > 0.2).mean()
        self.assertTrue(red > 0.01 and 0.5 < red / blue < 2, "a vortex moves up on one side and down on the other")
        names = self.sphk("plot", "run", "--field", "|v|", "--all", "--out", "frames/").split()
        self.assertEqual(names, ["frames/snap_0000_map_|v|.png", "frames/snap_0001_map_|v|.png"])
        text = self.sphk("plot", "run", "--field", "v_w", code=2)
        self.assertRegex(text, r"no field \"v_w\".*\brho, v, v_x, v_y, ")
        self.assertNotIn("v_z", text, "gas in 2D")
        self.assertIn("not positive", self.sphk("plot", "run", "--field", "v_x", "--log", code=2))
        self.sphk("plot", "run", "--field", "P", "--log", "--out", "pressure.pdf")
        with open(os.path.join(self.folder, "pressure.pdf"), "rb") as file:
            self.assertEqual(file.read(5), b"%PDF-")
        for wrong in (("--log",), ("--field", "v_x", "--range", "1,0"), ("--field", "P", "--range", "0,1", "--log"),
                      ("--field", "P", "--profile", "P"), ("--profile", "P", "--all"), ("--out", "x.gif")):
            self.sphk("plot", "run", *wrong, code=2)

    def test_alpha_and_errors_are_drawn_where_a_snapshot_has_them(self):
        self.sphk("run", "gresho", "-n", "16", "--set", "scene.dimension=2", "--scheme", "sphs", "--steps", "2",
                  "--set", "output.errors=true", "--out", "vortex")
        self.sphk("plot", "vortex")
        image = matplotlib.image.imread(os.path.join(self.folder, "vortex", "snap_0001.png"))
        self.assertGreater(image.shape[0] / image.shape[1], 0.5)  # two rows: rho, v, P; alpha, E0
        self.assertGreater(share(image[..., :3].reshape(-1, 3), "#009e73"), 1e-4, "the mean radial E0")
        for field in ("alpha", "E0", "E0_R", "v_phi"):
            self.assertEqual(self.sphk("plot", "vortex", "--profile", field).split(),
                             [f"vortex/snap_0001_profile_{field}.png"])
        pixels = colours(os.path.join(self.folder, "vortex", "snap_0001_profile_v_phi.png"))[0]
        self.assertGreater(share(pixels, "#d55e00"), 1e-3, "the exact line")
        self.sphk("run", "sod", "--set", "scene.dimension=1", "-n", "16", "--scheme", "gadget2", "--steps", "1",
                  "--out", "plain")
        self.assertIn("no field \"alpha\"", self.sphk("plot", "plain", "--profile", "alpha", code=2))

    def test_run_json_tells_who_ran_what_where_and_when(self):
        with open(os.path.join(self.folder, "run", "run.json"), encoding="utf-8") as file:
            run = json.load(file)
        self.assertEqual(shlex.split(run["command"])[1:6], ["run", "gresho", "-n", "16", "--set"])
        self.assertEqual(run["host"], socket.gethostname())
        started = datetime.datetime.strptime(run["date"], "%Y-%m-%dT%H:%M:%S%z")
        self.assertLess(abs(datetime.datetime.now(datetime.timezone.utc) - started), datetime.timedelta(hours=1))
        self.assertIn("-O", run["compiler_flags"])
        self.assertRegex(run["kokkos"], r"^\d+\.\d+\.\d+ for [A-Z]")

    def test_a_study_goes_on_when_nobody_reads_what_it_says(self):
        study = [SPHK, "study", "sod", "-n", "8,16", "--scheme", "sph,gadget2", "--set", "scene.dimension=1", "--out",
                 "unread"]
        running = subprocess.Popen(study, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        running.stdout.readline()
        running.stdout.close()
        self.assertEqual((running.wait(), running.stderr.read()), (0, ""))
        running.stderr.close()
        self.assertEqual(len(self.rows("unread/study.csv")), 4)
        pixels = colours(os.path.join(self.folder, "unread", "speed.png"))[0]
        for colour in ("#0072b2", "#d55e00"):
            self.assertGreater(share(pixels, colour), 1e-2, "a bar a method")

    def test_a_study_reads_files_alone(self):
        os.makedirs(os.path.join(self.folder, "folder"), exist_ok=True)
        os.mkfifo(os.path.join(self.folder, "pipe.csv"))
        for others, word in (("pipe.csv", "pipe"), ("folder", "folder"), ("none.csv", "no such file")):
            self.assertIn(word, self.sphk("study", "sod", "-n", "8", "--others", others, "--out", "never", code=2))
        self.assertIn("pipe", self.sphk("study", "compare", "pipe.csv", "folder", code=2))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "never")))
        snapshot, folder = "snap_0000.hdf5", os.path.join(self.folder, "folder")
        os.link(os.path.join(self.folder, "run", snapshot), os.path.join(folder, snapshot))
        for name, command in (("run.json", ("info", "folder")), ("history.csv", ("plot", "folder"))):
            os.mkfifo(os.path.join(folder, name))
            self.assertIn(f"folder/{name}: this is a pipe", self.sphk(*command, code=2))


unittest.main()
