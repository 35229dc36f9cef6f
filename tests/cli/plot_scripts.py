# SPDX-License-Identifier: BSD-3-Clause
"""What the drawing scripts make of work orders, in numbers. Usage: plot_scripts.py SPHK; exit code 77: no matplotlib."""

import importlib.util
import os
import sys
import tempfile
import unittest

try:
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: figures need python3-matplotlib")
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(sys.argv.pop())), "share/sphk/python"))
from sphk.figures import field_map, history, pages, profiles  # noqa: E402
from sphk.figures.snapshot import Snapshot  # noqa: E402
from sphk.figures.style import label_of, plt  # noqa: E402

def item(**numbers):
    return {"dimension": 2, "abscissa": "R", "from": 0, "to": 0.5, "exact": None, "time": 0, "title": "",
            "fields": list(numbers), "numbers": {"abscissa": np.linspace(0.01, 0.49, 200)} | numbers}


def image(values, cover=None, name="v_x", column=False):
    work = {"values": np.array(values), "cover": cover, "window": (0, 1, 0, 1), "column": column}
    return field_map.image_of({"images": {name: work}}, name)


class Scripts(unittest.TestCase):
    def test_gas_fades_where_it_ends_and_what_is_not_seen_sets_no_scale(self):
        full, none = field_map.FADES
        cover = np.array([[1, full, (full + none) / 2], [none, none / 2, 0]])
        picture = image([[1.0, 2, 3], [4, 5, np.nan]], cover)
        np.testing.assert_allclose(picture.opacity, [[1, 1, 0.5], [0, 0, 0]])
        self.assertEqual(set(picture.seen()), {1, 2})
        self.assertEqual(image([[1.0, np.nan]]).opacity.tolist(), [[1, 0]], "a closed box is opaque")

    def test_a_density_falls_to_zero_where_gas_ends(self):
        picture = image([[4.0, 3, 2, np.nan]], np.array([[1.01, 0.95, field_map.INSIDE / 2, 0]]), "rho")
        np.testing.assert_allclose(picture.values, [[4, 3, 1, 0]])
        self.assertEqual((picture.opacity.min(), len(picture.seen())), (1, 2), "its border sets no scale")
        norm = field_map.colours_of([picture])["norm"]
        self.assertEqual((norm.vmin, norm.vmax), (0, 4))
        self.assertEqual(image([[0, 1e-5, 1.0]], None, "rho", column=True).seen().tolist(), [1])

    def test_images_share_a_scale_which_knows_signs(self):
        images = [image([[1, 2], [3, low]]) for low in (0.5, 5)]
        norm = field_map.colours_of(images)["norm"]
        self.assertEqual((norm.vmin, norm.vmax), (0.5, 5))
        both = field_map.colours_of([image([[-1, 2], [3, 0.5]])], "v_y")["norm"]
        self.assertEqual((both.vmin, both.vmax), (-3, 3))
        asked = field_map.colours_of(images, "v_y", {"range": [1, 2], "log": True})["norm"]
        self.assertEqual((type(asked).__name__, asked.vmin, asked.vmax), ("LogNorm", 1, 2))

    def test_frames_share_their_axes(self):
        frames = [item(rho=np.full(200, value)) for value in (2.0, 5.0)]
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
        self.assertTrue(1e-7 < low < 1e-6 < high < 1e-5, (low, high))
        history.scale_drifts(axes, [np.array([1e-4, 1e-3])])
        self.assertGreater(axes.get_ylim()[1], 0.01, "one per cent is near")
        plt.close(figure)
        figure, axes = plt.subplots()
        history.scale_drifts(axes, [np.array([0.0, 0.0])])
        self.assertEqual((axes.get_yscale(), len(axes.get_yticks())), ("linear", 0), "nothing has drifted")
        plt.close(figure)

    @unittest.skipUnless(importlib.util.find_spec("jinja2"), "pages need python3-jinja2")
    def test_a_page_needs_nothing_beside_it(self):
        with tempfile.NamedTemporaryFile(suffix=".png") as picture:
            picture.write(b"foobar")  # whose base64 is that of RFC 4648 sec 10
            picture.flush()
            tile = {"file": picture.name, "name": "a < \"b\"", "summary": "", "words": "<48>", "command": "x & y"}
            page = pages.page_of({"page": "gallery.html", "title": "a < b", "machine": "", "tiles": [tile]})
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        for text in ("<title>a &lt; b</title>", "&lt;48&gt;", "x &amp; y", 'src="data:image/png;base64,Zm9vYmFy"'):
            self.assertIn(text, page)
        self.assertRegex(page, r'alt="a &lt; &#34;b&#34;"')
        for link in ("http:", "https:", "url(", "<script", "<link"):
            self.assertNotIn(link, page)

    def test_labels_name_components(self):
        self.assertIn("v_{x}", label_of("v_x"))
        self.assertIn(r"\varphi", label_of("v", "phi"))
        self.assertIn("|E_0|", label_of("E0"))
        self.assertEqual(label_of("EntropyContrast"), "EntropyContrast")


unittest.main()
