# SPDX-License-Identifier: BSD-3-Clause
"""`sphk plot` gives PNG files that show something. Usage: figures.py SPHK; exit code 77: no matplotlib."""

import base64
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest
from html.parser import HTMLParser

try:
    import jinja2  # noqa: F401
    import matplotlib.image
except ImportError:
    print("skipped: figures and pages need python3-matplotlib and python3-jinja2")
    sys.exit(77)

SPHK = sys.argv.pop()


def colours(path):
    """Pixels of a PNG and the number of different colours among them."""
    pixels = matplotlib.image.imread(path)[..., :3].reshape(-1, 3)
    return pixels, len({tuple(p) for p in (pixels[::7] * 255).astype(int)})


def share(pixels, colour):
    """Part of the pixels that have this colour, #rrggbb, within 2 of 255."""
    wanted = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    return (abs(pixels - wanted).max(1) < 2.5 / 255).mean()


class Page(HTMLParser):
    """The words of a page, and which elements are still open."""

    VOID = {"meta", "img", "br"}

    def __init__(self):
        super().__init__()
        self.open, self.words = [], []

    def handle_starttag(self, tag, attributes):
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words.append(data)


class WithRun(unittest.TestCase):
    """A folder with a small run."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        cls.sphk("run", "gresho", "-n", "16", "--set", "scene.dimension=2", "--steps", "4", "--out", "run")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def sphk(cls, *arguments, code=0, **environment):
        done = subprocess.run([SPHK, *arguments], cwd=cls.folder, env=os.environ | environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert done.returncode == code, done.stdout
        return done.stdout

    def rows(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)


class Figures(WithRun):
    def test_a_run_gives_profiles_a_map_and_a_history(self):
        names = self.sphk("plot", "run").split()
        self.assertEqual([os.path.basename(n) for n in names], ["snap_0001.png", "snap_0001_map.png", "history.png"])
        pixels, count = colours(os.path.join(self.folder, names[0]))
        self.assertGreater(count, 20)
        self.assertGreater(share(pixels, "#d55e00"), 1e-3)  # the exact line
        self.assertGreater(share(pixels, "#0072b2"), 1e-4)  # the bin means
        self.assertGreater(colours(os.path.join(self.folder, names[1]))[1], 100)  # a map has shades
        self.assertGreater(os.path.getsize(os.path.join(self.folder, names[2])), 10000)

    def test_layers_give_a_map_in_3d_and_their_measures(self):
        self.sphk("run", "kh12", "-n", "16", "--set", "scene.layers=2", "--steps", "2", "--out", "layers")
        names = self.sphk("plot", "layers").split()
        self.assertEqual([os.path.basename(n) for n in names], ["snap_0001.png", "snap_0001_map.png", "history.png"])
        self.assertGreater(colours(os.path.join(self.folder, names[1]))[1], 100)
        height, width = matplotlib.image.imread(os.path.join(self.folder, names[2])).shape[:2]
        self.assertGreater(height / width, 0.5)  # two rows of panels: the drifts and energies, then M, W, mixA, crossed

    def test_axes_name_the_units_that_a_run_was_given(self):
        units = ("--set", "units.length=kpc", "--set", "units.mass=1e10 Msun", "--set", "units.velocity=km/s")
        self.sphk("run", "gresho", "-n", "16", "--set", "scene.dimension=2", "--steps", "1", *units, "--out", "galactic")
        self.assertEqual(len(self.sphk("plot", "galactic").split()), 3)
        refused = self.sphk("plot", "run", "galactic", "--out", "both.png", code=2)
        self.assertIn("different units", refused)  # one colour scale would compare numbers of unlike meaning

    def test_labels_have_a_unit_where_there_is_one(self):
        sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../src/python"))
        from sphk.figures.style import field_label, time_of

        item = {"abscissa": "R", "time": 0.5, "units": {"x": "kpc", "rho": "1e10 Msun kpc^-3", "t": "977.79 Myr"}}
        self.assertEqual(field_label(item, "R"), r"cylindrical radius $R$ [kpc]")
        self.assertEqual(field_label(item, "rho"), r"density $\rho$ [10$^{10}$ M$_\odot$ kpc$^{-3}$]")
        self.assertEqual(time_of(item), "t = 0.5 [977.79 Myr]")
        self.assertEqual(field_label(item | {"units": None}, "R"), r"cylindrical radius $R$")

    def test_two_runs_share_one_scale_side_by_side(self):
        self.sphk("run", "gresho", "-n", "16", "--set", "scene.dimension=2", "--steps", "1", "--out", "other")
        self.sphk("plot", "run", "other/snap_0000.hdf5", "--out", "both.png")
        image = matplotlib.image.imread(os.path.join(self.folder, "both.png"))
        self.assertGreater(image.shape[1] / image.shape[0], 1.4)  # two square maps in a row
        self.assertIn("--out FILE.png", self.sphk("plot", "run", "other", code=2))

    def test_runs_show_how_well_they_conserve_in_one_figure(self):
        self.sphk("run", "gresho", "-n", "16", "--set", "scene.dimension=2", "--scheme", "gadget2", "--steps", "1",
                  "--out", "third")
        self.sphk("plot", "run", "third", "--conservation", "--out", "conserved.png")
        pixels = colours(os.path.join(self.folder, "conserved.png"))[0]
        for colour in ("#0072b2", "#d55e00"):
            self.assertGreater(share(pixels, colour), 1e-5, "a line a run")
        self.assertIn("--out FILE.png", self.sphk("plot", "run", "--conservation", code=2))

    def test_errors_of_runs_share_one_figure(self):
        for scheme in ("sph", "osph"):
            self.sphk("run", "kh12", "-n", "16", "--set", "scene.dimension=2", "--scheme", scheme, "--steps", "1",
                      "--set", "output.errors=true", "--out", scheme)
        self.sphk("plot", "sph", "osph", "--errors", "--out", "errors.png")
        image = matplotlib.image.imread(os.path.join(self.folder, "errors.png"))
        self.assertGreater(image.shape[1] / image.shape[0], 1.5)  # two rows of five panels
        self.assertGreater(share(colours(os.path.join(self.folder, "errors.png"))[0], "#0072b2"), 1e-4)  # means along y
        self.assertIn("output.errors=true", self.sphk("plot", "run", "--errors", "--out", "none.png", code=2))

    def test_one_field_of_several_runs_is_drawn_a_panel_each(self):
        tube = ("--set", "scene.dimension=1", "--set", "scene.variant=v10", "-n", "64", "--steps", "3")
        for kernel in ("liq0.2", "cs"):
            self.sphk("run", "sod", *tube, "--kernel", kernel, "--out", kernel)
        self.sphk("plot", "liq0.2", "cs", "--profile", "rho", "--out", "tubes.png")
        pixels, count = colours(os.path.join(self.folder, "tubes.png"))
        self.assertGreater(share(pixels, "#d55e00"), 1e-3)  # the exact line
        self.assertIn("--out FILE.png", self.sphk("plot", "liq0.2", "cs", "--profile", "rho", code=2))

    def test_the_papers_tables_come_as_csv_and_a_figure(self):
        text = self.sphk("tables", "--out", "tables")
        tables = ("s12-table-1", "r10-table-1", "v10-table-1", "s12-figure-1")
        rows = {}
        for name in tables:
            with open(os.path.join(self.folder, "tables", name + ".csv"), encoding="utf-8") as file:
                rows[name] = list(csv.DictReader(file))
        self.assertEqual([len(rows[name]) for name in tables], [30, 24, 48, 6])
        self.assertTrue(all(row["agrees"] == "yes" for row in rows["r10-table-1"]), "R10's digits")
        lattice = [row for row in rows["s12-table-1"] if "simple" in row["row"]]
        self.assertTrue(all(row["agrees"] == "yes" for row in lattice), "S12's lattice")
        agreeing = sum(row["agrees"] == "yes" for name in tables for row in rows[name])
        self.assertIn(f"{agreeing} of 108 printed values agree", text)
        pixels = colours(os.path.join(self.folder, "tables", "kernels.png"))[0]
        for colour in ("#0072b2", "#d55e00", "#009e73"):
            self.assertGreater(share(pixels, colour), 1e-4, "a line a kernel")

    def test_a_study_gives_a_table_a_figure_and_goes_on_where_it_was(self):
        study = ("study", "sod", "-n", "8,16", "--scheme", "sph,gadget2", "--set", "scene.dimension=1", "--target", "0.2",
                 "--out", "study")
        text = self.sphk(*study)
        self.assertIn("4 points of sod, 4 of them to run", text)
        self.assertIn("CPU s to an error of 0.2", text)
        self.assertIn("4 points of sod, 0 of them to run", self.sphk(*study))
        self.assertIn("1 of them to run", self.sphk(*study[:3], "8,16,24", "--scheme", "sph", *study[6:]))
        rows = self.rows("study/study.csv")
        self.assertEqual([row["n"] for row in rows], ["8", "16", "24"])
        self.assertTrue(all(float(row["error"]) > 0 and float(row["cpu_seconds"]) > 0 for row in rows))
        self.assertGreater(share(colours(os.path.join(self.folder, "study", "study.png"))[0], "#0072b2"), 1e-4)
        other = list(study[:-1]) + ["other", "--set", "viscosity.alpha=3"]
        self.sphk(*other)
        self.assertIn("another folder", self.sphk(*study[:-1], "other", code=2), "it has other keys")
        there = self.sphk("study", "compare", "study", "other/study.json")
        back = self.sphk("study", "compare", "other", "study")
        self.assertIn("4 points compared", there)
        self.assertIn("larger error", there + back)  # another viscosity has other errors, one way or the other
        ratios = [[float(x) for x in re.findall(r"(?:8|16) +(\d+\.\d+) ", text)] for text in (there, back)]
        self.assertEqual(len(ratios[0]), 4)
        for one, other_way in zip(*ratios):
            self.assertAlmostEqual(one * other_way, 1, delta=0.005)
        self.assertIn("is no study", self.sphk("study", "compare", "study", "run", code=2))
        self.assertIn("gadget2", self.sphk("study", "sod", "--scheme", "gadget", "--out", "bad", code=2))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "bad")), "nothing runs where a name is wrong")

    def test_a_study_file_gives_a_report_with_failures_and_other_engines(self):
        self.write("mine.toml", 'scene = "sod"\ntarget = 0.5\nbudgets = [10]\nothers = "peers.csv"\nrepeat = 2\n'
                                "[set]\nscene.dimension = 1\n[vary]\nscene.n = [8, 16]\n"
                                '[[methods]]\nsph.scheme = "gadget2"\n'
                                "[[methods]]\nsph.neighbours = 1\n")  # fewer than the particle itself counts for
        self.write("peers.csv", "engine,setting,error,cpu_seconds,machine\nSWIFT,classic <48>,0.4,1e6,A machine\n")
        text = self.sphk("study", "mine.toml", "--report", "report.html")
        self.assertIn("4 points of sod, 4 of them to run, 2 times each in mine", text)
        self.assertRegex(text, r"SWIFT, classic <48> +0.4 +1e\+06 +below 0\.0")
        self.assertNotIn("Speed", text, "one method alone")
        rows = self.rows("mine/study.csv")
        self.assertEqual([row["failure"] != "" for row in rows], [False, False, True, True])
        with open(os.path.join(self.folder, "mine", "study.json"), encoding="utf-8") as file:
            points = json.load(file)["points"]
        runs = points["scheme-gadget2_n-16"]["runs"]
        self.assertEqual(len(runs), 2)
        self.assertAlmostEqual(float(rows[1]["cpu_seconds"]), min(run["cpu_seconds"] for run in runs), delta=1e-5)
        with open(os.path.join(self.folder, "report.html"), encoding="utf-8") as file:
            page = file.read()
        figure = re.search(r'src="data:image/png;base64,([^"]+)"', page).group(1)
        with open(os.path.join(self.folder, "mine", "study.png"), "rb") as file:
            self.assertEqual(base64.b64decode(figure), file.read())
        parser = Page()
        parser.feed(page)
        self.assertEqual(parser.open, [], "every element is closed")
        self.assertIn("SWIFT, classic <48>", parser.words)
        self.assertIn("failed", parser.words)
        self.assertIn("A machine", " ".join(parser.words))

    def test_a_study_of_layers_measures_their_distance_from_converged_runs(self):
        self.sphk("study", "mcnally", "-n", "8,16", "--set", "time.end=0.6", "--out", "layers-study")
        rows = self.rows("layers-study/study.csv")
        for row in rows:  # the only reference up to then: M = 0.0105 at t = 0.5
            history = self.rows(f"layers-study/points/n-{row['n']}/history.csv")
            M = next(float(h["M"]) for h in history if abs(float(h["time"]) - 0.5) < 1e-9)
            self.assertAlmostEqual(float(row["error"]), abs(M - 0.0105) / 0.0105, places=6)
        self.assertIn("scene.edges=soft", self.sphk("study", "kh12", "-n", "8", code=2))
        self.assertIn("neither an exact solution", self.sphk("study", "shearing", "-n", "8", code=2))
        self.sphk("study", "kh12", "-n", "8", "--norm", "mixA", "--set", "scene.dimension=2", "--set", "time.end=0.1",
                  "--out", "measured")
        history = self.rows("measured/points/n-8/history.csv")
        told = float(self.rows("measured/study.csv")[0]["error"])
        self.assertAlmostEqual(told, float(history[-1]["mixA"]), places=8)
        text = self.sphk("study", "kh12", "-n", "8", "--norm", "banana", "--set", "scene.dimension=2",
                         "--set", "time.end=0.1", "--out", "wrong", code=2)
        self.assertIn("mixA", text, "what it does measure")
        self.assertIn("--norm M", self.sphk("study", "mcnally", "--norm", "v", code=2))

    def test_a_stopped_study_goes_on(self):
        study = [SPHK, "study", "sod", "-n", "48", "--scheme", "sphs,sph", "--set", "scene.across=8", "--out", "stopped"]
        running = subprocess.Popen(study, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        log = os.path.join(self.folder, "stopped", "points", "scheme-sphs_n-48.log")
        while running.poll() is None and not (os.path.exists(log) and os.path.getsize(log) > 0):
            time.sleep(0.002)
        running.terminate()
        text = running.communicate()[0]
        self.assertEqual(running.returncode, 75, text)
        self.assertIn("goes on where it was", text)
        self.assertIn("of them to run", self.sphk(*study[1:]))
        self.assertTrue(all(float(row["error"]) > 0 for row in self.rows("stopped/study.csv")))

    def test_extremes_tell_what_is_required_and_what_came_out(self):
        short = ["blast", "rarefactions", "expansion-2d", "point-explosion", "point-explosion-late", "contrast-3"]
        short += ["contrast-6-sheared", "square", "boost", "lattice-broken"]
        self.assertIn("10 of 10 cases pass", self.sphk("extremes", *short))
        with open(os.path.join(self.folder, "extremes", "extremes.txt"), encoding="utf-8") as file:
            rows = file.read().splitlines()
        self.assertEqual(sum(row.endswith("pass") for row in rows), len(rows) - 1, "a line a requirement, below the head")
        self.assertIn("known are settling,", self.sphk("extremes", "blasst", code=2))

    def test_the_gallery_is_one_page_with_a_picture_a_scene(self):
        text = self.sphk("gallery", "uniform", "gresho", "--out", "gallery")
        self.assertIn("[2/2] uniform", text)
        with open(os.path.join(self.folder, "gallery", "index.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertEqual(page.count("data:image/png;base64,"), 2)
        parser = Page()
        parser.feed(page)
        self.assertEqual(parser.open, [])
        self.assertGreater(share(colours(os.path.join(self.folder, "gallery", "gallery.png"))[0], "#d55e00"), 1e-3)
        self.assertIn("gresho", self.sphk("gallery", "grecho", code=2))

    def test_stability_maps_have_stable_and_unstable_parts(self):
        text = self.sphk("stability", "--kernel", "cs", "--neighbours", "32", "--lattice", "square", "--out", "maps")
        least = re.search(r"unstable: the least is (\S+);", text).group(1)
        self.assertAlmostEqual(float(least), -4.2e-2, delta=1e-3)  # an independent computation's
        self.assertGreater(colours(os.path.join(self.folder, "maps", "stability.png"))[1], 100)
        with open(os.path.join(self.folder, "maps", "stability.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * 64 * 48)
        self.assertTrue(any(float(row["transverse"]) < -0.01 for row in rows))
        self.assertTrue(all(row["transverse_z"] == "nan" for row in rows), "a square lattice has one wave across k")
        self.assertIn("cubical", self.sphk("stability", "--kernel", "cs", "--neighbours", "32", "--lattice", "cubical",
                                           code=2))

    def test_without_exact_there_is_no_exact_line(self):
        self.sphk("plot", "run/snap_0000.hdf5", "--no-exact", "--out", "bare.png")
        self.assertLess(share(colours(os.path.join(self.folder, "bare.png"))[0], "#d55e00"), 1e-4)

    def test_a_snapshot_alone_is_drawn_without_its_run(self):
        os.makedirs(os.path.join(self.folder, "alone"), exist_ok=True)
        os.link(os.path.join(self.folder, "run/snap_0001.hdf5"), os.path.join(self.folder, "alone/snap.hdf5"))
        self.sphk("plot", "alone/snap.hdf5")
        self.assertTrue(os.path.exists(os.path.join(self.folder, "alone/snap.png")))

    def test_a_run_is_drawn_from_its_folder_where_its_initial_condition_is_gone(self):
        start = os.path.join(self.folder, "ic.hdf5")
        with open(os.path.join(self.folder, "run", "snap_0001.hdf5"), "rb") as source, open(start, "wb") as copy:
            copy.write(source.read())
        self.sphk("run", "ic.hdf5", "--t-end", "0.1", "--steps", "2", "--out", "from-file")
        os.remove(start)
        names = self.sphk("plot", "from-file").split()
        self.assertIn("snap_0001.png", [os.path.basename(n) for n in names])

    def test_a_python_without_matplotlib_is_named_with_the_cure(self):
        text = self.sphk("plot", "run", code=2, SPHK_PYTHON="/nonexistent/python3")
        self.assertIn("apt-get install python3-matplotlib", text)


if __name__ == "__main__":
    unittest.main()
