"""What the drawing scripts make of snapshots, in numbers. Usage: plot_scripts.py SPHK; exit code 77: no matplotlib."""

import os
import sys
import tempfile
import unittest

try:
    import h5py
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: figures need python3-matplotlib and python3-h5py")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(sys.argv.pop())), "share/sphk/python"))
from sphk.figures import field_map, history, profiles  # noqa: E402
from sphk.figures.snapshot import Snapshot  # noqa: E402
from sphk.figures.style import label_of, plt  # noqa: E402

SIDE = 24


def item(file, periodic, **more):
    return {"file": file, "dimension": 2, "box_lower": [0, 0, 0], "box_size": [1, 1, 1], "periodic": [periodic] * 3,
            "centre": [0.5, 0.5, 0], "velocity": [0, 0, 0], "abscissa": "R", "from": 0, "to": 0.5, "exact": None,
            "time": 0, "title": "", "fields": [],
            "names": {"rho": ["Densities", ""], "m": ["Masses", ""], "v": ["Velocities", "phi"],
                      "|v|": ["Velocities", "modulus"], "v_x": ["Velocities", "x"], "v_R": ["Velocities", "R"],
                      "v_phi": ["Velocities", "phi"], "v_r": ["Velocities", "r"], "V_xy": ["V", "xy"]}} | more


class Scripts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.file = os.path.join(cls.temporary.name, "gas.hdf5")
        places = (np.arange(SIDE) + 0.5) / SIDE
        cls.x = np.stack([*np.meshgrid(places, places), np.zeros((SIDE, SIDE))], -1).reshape(-1, 3)
        d = cls.x - [0.5, 0.5, 0]
        with h5py.File(cls.file, "w") as file:
            gas = file.create_group("PartType0")
            gas["Coordinates"] = cls.x
            gas["Velocities"] = np.stack([3 * d[:, 0] - 4 * d[:, 1], 4 * d[:, 0] + 3 * d[:, 1], 0 * d[:, 0]], -1)
            gas["Densities"], gas["Masses"] = np.full(len(d), 2.0), np.full(len(d), 2.0 / len(d))
            gas["V"] = np.outer(np.ones(len(d)), np.arange(6))
        cls.R = np.hypot(d[:, 0], d[:, 1])

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_parts_of_vectors_and_matrices(self):
        """A flow of 3 R outwards and 4 R around the centre: 5 R in all."""
        gas = Snapshot(item(self.file, False))
        for name, factor in (("v_R", 3), ("v_r", 3), ("v_phi", 4), ("v", 4), ("|v|", 5)):
            np.testing.assert_allclose(gas.value(name), factor * self.R, atol=1e-12, err_msg=name)
        np.testing.assert_allclose(gas.value("v_x"), 3 * (self.x[:, 0] - 0.5) - 4 * (self.x[:, 1] - 0.5), atol=1e-12)
        self.assertEqual(set(gas.value("V_xy")), {3}, "behind xx, yy, zz")

    def test_velocities_about_a_centre_are_beside_its_own(self):
        gas = Snapshot(item(self.file, False, velocity=[7, 0, 0]))
        outwards = (self.x[:, 0] - 0.5) / self.R
        np.testing.assert_allclose(gas.value("v_R"), 3 * self.R - 7 * outwards, atol=1e-12)
        np.testing.assert_allclose(gas.value("v_x"), Snapshot(item(self.file, False)).value("v_x"))

    def test_maps_show_the_field_and_end_with_the_gas(self):
        gas = Snapshot(item(self.file, True))
        image = field_map.field_image(gas, "rho", *field_map.frame(gas))
        self.assertEqual(image.values.shape, (field_map.PIXELS, field_map.PIXELS))
        np.testing.assert_allclose(image.values, 2, rtol=1e-12)
        self.assertEqual(image.opacity.min(), 1, "a periodic box has no border")
        middle = field_map.PIXELS // 2
        image = field_map.field_image(gas, "v_x", *field_map.frame(gas))
        self.assertAlmostEqual(image.values[middle, middle + 64], 3 * 64.5 / 320 - 4 * 0.5 / 320, delta=1e-3)
        gas = Snapshot(item(self.file, False))
        image = field_map.field_image(gas, "rho", np.array([-0.5, -0.5]), np.array([2, 2]))
        self.assertEqual(image.opacity[middle, middle], 1)
        self.assertEqual(image.opacity[5, 5], 0)
        self.assertEqual(image.seen().max(), image.seen().min(), "its border is not darker than its inside")
        border = (image.opacity > 0.5).sum() * (2 / field_map.PIXELS) ** 2
        self.assertAlmostEqual(border, 1, delta=4 * 0.5 / SIDE, msg="half a spacing around a square of area 1")

    def test_images_share_a_scale_which_knows_signs(self):
        full = np.ones((2, 2))
        images = [field_map.Image(np.array([[1, 2], [3, low]]), full) for low in (0.5, 5)]
        norm = field_map.colours_of(images)["norm"]
        self.assertEqual((norm.vmin, norm.vmax), (0.5, 5))
        both = field_map.colours_of([field_map.Image(np.array([[-1, 2], [3, 0.5]]), full)], "v_y")["norm"]
        self.assertEqual((both.vmin, both.vmax), (-3, 3))
        asked = field_map.colours_of(images, "v_y", {"range": [1, 2], "log": True})["norm"]
        self.assertEqual((type(asked).__name__, asked.vmin, asked.vmax), ("LogNorm", 1, 2))

    def test_frames_share_their_axes(self):
        frames = [item(self.file, True, fields=["rho"]), item(self.file, True, fields=["rho"])]
        frames[1]["names"] = frames[1]["names"] | {"rho": ["V", "yz"]}  # 5 in place of 2
        low, high = profiles.shared_limits(Snapshot(frame) for frame in frames)["rho"]
        self.assertTrue(1.9 < low < 2 and 5 < high < 5.1, (low, high))

    def test_an_axis_is_not_set_by_one_particle(self):
        values = np.append(np.linspace(0, 1, 1000), 1000)
        low, high = profiles.limits(values)
        self.assertLess(high, 1.5)
        self.assertGreater(profiles.limits(values, [40])[1], 40, "the exact solution is always shown")
        self.assertGreater(profiles.limits(np.linspace(0, 1, 1000))[1], 1, "and so is what is not far out")

    def test_drifts_end_where_they_end(self):
        figure, axes = plt.subplots()
        history.scale_drifts(axes, [np.array([0, 1e-6]), np.array([0.0, 0.0])])
        low, high = axes.get_ylim()
        self.assertTrue(1e-7 < low < 1e-6 and 0.01 < high < 0.1, (low, high))
        plt.close(figure)
        figure, axes = plt.subplots()
        history.scale_drifts(axes, [np.array([0.0, 0.0])])
        self.assertEqual((axes.get_yscale(), len(axes.get_yticks())), ("linear", 0), "nothing has drifted")
        plt.close(figure)

    def test_labels_name_components(self):
        self.assertIn("v_{x}", label_of("v_x"))
        self.assertIn(r"\varphi", label_of("v", "phi"))
        self.assertIn("|E_0|", label_of("E0"))
        self.assertEqual(label_of("EntropyContrast"), "EntropyContrast")


unittest.main()
