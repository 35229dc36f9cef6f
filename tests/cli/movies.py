# SPDX-License-Identifier: BSD-3-Clause
"""Films and live pictures. Usage: movies.py SPHK; exit code 77: no matplotlib."""

import os
import re
import shutil
import subprocess
import unittest

from figures import WithRun, colours  # first: it tells where matplotlib is missing
import numpy as np
from PIL import Image, ImageSequence


class Movies(WithRun):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, scheme in (("film", "sph"), ("other", "gadget2")):
            cls.sphk("run", "kh12", "-n", "16", "--set", "scene.dimension=2", "--scheme", scheme, "--t-end", "0.3",
                     "--set", "output.snapshots=4", "--out", name)

    def frames(self, name):
        with Image.open(os.path.join(self.folder, name)) as film:
            return [np.asarray(frame.convert("RGB"), dtype=float) for frame in ImageSequence.Iterator(film)]

    def test_a_film_moves_on_one_scale(self):
        self.assertEqual(self.sphk("movie", "film", "--out", "kh.gif").split(), ["kh.gif"])
        frames = self.frames("kh.gif")
        self.assertEqual(len(frames), 5)
        height, width = frames[0].shape[:2]
        # The numbers beside the bar of colours stay; a few pixels of noise are those of a GIF's 256 colours.
        bar = [frame[height // 5:, int(0.9 * width):] for frame in frames]
        for k in range(1, 5):
            self.assertLess((abs(bar[k] - bar[0]).max(-1) > 60).mean(), 1e-3)
        self.assertGreater((abs(frames[-1] - frames[0]).max(-1) > 30).mean(), 0.01)

    def test_runs_are_side_by_side_and_snapshots_are_left_out_on_request(self):
        self.sphk("movie", "film", "other", "--field", "v_y", "--range", "-0.1,0.1", "--every", "3", "--pixels", "64",
                  "--out", "two.gif")
        frames = self.frames("two.gif")
        self.assertEqual(len(frames), 3, "0, 3 and the last")
        self.assertGreater(frames[0].shape[1] / frames[0].shape[0], 1.5)

    def test_a_page_holds_its_pictures(self):
        self.sphk("movie", "film", "--window", "0.25,0.75,0,0.5", "--log", "--out", "kh.html")
        with open(os.path.join(self.folder, "kh.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(page.count("data:image/png;base64,"), 5)
        self.assertEqual(os.listdir(self.folder).count("kh_frames"), 0)

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg")
    def test_ffmpeg_makes_what_players_show(self):
        self.sphk("movie", "film", "--fps", "5", "--out", "kh.mp4")
        told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                               "stream=codec_name,pix_fmt,nb_read_frames,r_frame_rate", "-of", "csv=p=0", "kh.mp4"],
                              cwd=self.folder, text=True, capture_output=True, check=True).stdout
        self.assertEqual(told.strip(), "h264,yuv420p,5/1,5")

    def test_without_ffmpeg_a_sentence_says_what_to_do(self):
        text = self.sphk("movie", "film", "--out", "kh.mp4", code=2, PATH="/nonexistent")
        self.assertIn("sudo apt-get install ffmpeg", text)
        self.assertIn("kh.gif", text)
        self.assertIn(".mp4", self.sphk("movie", "film", "--out", "kh.avi", code=2))

    def test_wishes_that_contradict_are_refused(self):
        for wrong in (("--window", "1,0,0,1"), ("--slice", "0.5", "--column"), ("--slice", "0.5"), ("--column",),
                      ("--range", "2,1"), ("--field", "banana"), ("--every", "0")):
            self.sphk("movie", "film", *wrong, "--out", "x.gif", code=2)
        self.sphk("run", "sod", "--set", "scene.dimension=1", "-n", "16", "--steps", "1", "--out", "tube")
        self.assertIn("one-dimensional", self.sphk("movie", "tube", "--out", "x.gif", code=2))

    def test_a_zoom_shows_a_part_of_the_map(self):
        """Where the layers meet, twice as large: the same colours at the same places."""
        for name, window in (("all", "0,1,0,1"), ("part", "0.25,0.75,0,0.5")):
            self.sphk("plot", "film", "--field", "rho", "--window", window, "--range", "0.9,2.1", "--out", name + ".png")
        whole, part = (colours(os.path.join(self.folder, name + ".png"))[0] for name in ("all", "part"))
        light = [(pixels.max(1) - pixels.min(1) > 0.3).mean() for pixels in (whole, part)]
        self.assertLess(abs(light[0] - light[1]), 0.05, "half of each is dense")
        self.assertIn("leave them out", self.sphk("plot", "film", "--profile", "rho", "--window", "0,1,0,1", code=2))

    def test_gas_in_3d_is_cut_or_summed(self):
        self.sphk("run", "uniform", "-n", "8", "--steps", "1", "--out", "box")
        for name, how in (("low", ("--slice", "0.1")), ("sum", ("--column",))):
            self.sphk("plot", "box", "--field", "rho", *how, "--out", name + ".pdf")
            with open(os.path.join(self.folder, name + ".pdf"), "rb") as file:
                text = file.read()
            self.assertIn(b"/FontFile2", text, "TrueType fonts are embedded")
            self.assertNotIn(b"/Type3", text)

    def test_a_run_is_watched_and_stays_what_it_is(self):
        run = ("run", "kh12", "-n", "32", "--set", "scene.dimension=2", "--t-end", "0.1")
        self.sphk(*run, "--out", "alone")
        self.sphk(*run, "--watch", "0.5", "--out", "watched")
        self.assertGreater(colours(os.path.join(self.folder, "watched", "watch.png"))[1], 100)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "watched", ".watch")))
        rows = [self.rows(name + "/history.csv") for name in ("alone", "watched")]
        self.assertEqual(*rows, "the same numbers")
        self.sphk(*run, "--steps", "1", "--overwrite", "--out", "watched")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "watched", "watch.png")), "it was of another run")

    def test_where_a_run_cannot_be_drawn_it_says_so_once(self):
        text = self.sphk("run", "kh12", "-n", "32", "--set", "scene.dimension=2", "--t-end", "0.1", "--watch", "0.01",
                         "--out", "unseen", SPHK_PYTHON="/nonexistent")
        self.assertEqual(len(re.findall("--watch cannot draw", text)), 1, text)
        self.assertIn("unseen is complete", text)


unittest.main()
