# SPDX-License-Identifier: GPL-3.0-or-later
"""What other programs take: dicts for trimesh, pictures by matplotlib."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import footfall
import numpy as np
import scenes

try:
    import matplotlib

    matplotlib.use("Agg")
except ImportError:
    matplotlib = None


def two_floors():
    """A ground of 10 x 10 with a wall without thickness in its middle, and a platform of 4 x 4 that is 3 higher."""
    wall = np.array([[5, 2, 0], [5, 8, 0], [5, 8, 1], [5, 2, 1]], dtype=float), scenes.QUAD
    return footfall.walkable_area(*scenes.together(scenes.floor(), wall, scenes.floor(0, 0, 4, 4, 3)))


class Trimesh(unittest.TestCase):
    def test_the_whole_mesh(self):
        area = two_floors()
        mesh = footfall.trimesh_dict(area)
        np.testing.assert_array_equal(mesh["vertices"], area.vertices)
        np.testing.assert_array_equal(mesh["faces"], area.triangles)
        self.assertEqual((mesh["vertices"].dtype, mesh["faces"].dtype), (np.float64, np.int64))
        self.assertTrue(mesh["vertices"].flags.writeable)
        self.assertFalse(mesh["process"])

    def test_one_layer(self):
        area = two_floors()
        self.assertEqual(area.layer_count, 2)
        total = 0
        for layer in range(2):
            mesh = footfall.trimesh_dict(area, layer)
            corners = mesh["vertices"][mesh["faces"]]
            np.testing.assert_array_equal(corners, np.asarray(area.vertices)[area.triangles[area.layers == layer]])
            self.assertEqual(len(mesh["vertices"]), len(np.unique(mesh["faces"])))
            total += np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2].sum() / 2
        self.assertAlmostEqual(total, 116)

    def test_layers_that_are_not_there(self):
        with self.assertRaisesRegex(footfall.InputError, "there is no layer 2; give numbers from 0 to 1"):
            footfall.trimesh_dict(two_floors(), 2)
        plain = footfall.NavigationMesh(*scenes.floor())
        with self.assertRaisesRegex(footfall.InputError, "this mesh has none"):
            footfall.trimesh_dict(plain, 0)
        self.assertEqual(len(footfall.trimesh_dict(plain)["faces"]), 2)


class Plot(unittest.TestCase):
    @unittest.skipUnless(matplotlib, "matplotlib is not installed (python3-matplotlib)")
    def test_a_picture_for_each_layer(self):
        area = two_floors()
        path = area.find_path((1, 5, 0), (9, 5, 0))
        figure = footfall.plot(area, path=path)
        shown = [axis for axis in figure.axes if axis.get_title().startswith("layer")]
        self.assertEqual([axis.get_title() for axis in shown], ["layer 0", "layer 1"])
        lines = [line for axis in shown for line in axis.get_lines()]
        walls = [line for line in lines if line.get_color() == "crimson"]
        self.assertAlmostEqual(sum(np.hypot(*np.diff(line.get_xydata(), axis=0).T).sum() for line in walls), 6)
        way = [line for line in lines if line.get_color() == "white"]
        self.assertAlmostEqual(sum(np.hypot(*np.diff(line.get_xydata(), axis=0).T).sum() for line in way),
                               path.plan_length)
        with tempfile.TemporaryFile() as file:
            figure.savefig(file, format="png")
            self.assertGreater(file.tell(), 1000)
        matplotlib.pyplot.close(figure)

    @unittest.skipUnless(matplotlib, "matplotlib is not installed (python3-matplotlib)")
    def test_some_layers_and_none(self):
        area = two_floors()
        figure = footfall.plot(area, 1)
        self.assertEqual([axis.get_title() for axis in figure.axes if axis.get_title()], ["layer 1"])
        matplotlib.pyplot.close(figure)
        figure = footfall.plot(footfall.NavigationMesh(*scenes.floor()))
        self.assertEqual(figure.axes[0].get_title(), "walkable")
        matplotlib.pyplot.close(figure)
        nothing = footfall.walkable_area(*scenes.floor(), height=2, minimum_area=1000)
        matplotlib.pyplot.close(footfall.plot(nothing))
        with self.assertRaises(footfall.InputError):
            footfall.plot(area, [0, 5])

    @unittest.skipUnless(matplotlib, "matplotlib is not installed (python3-matplotlib)")
    def test_the_walkthrough_makes_its_pictures(self):
        script = pathlib.Path(__file__).parents[3] / "bindings/python/examples/walkthrough.py"
        house = pathlib.Path(os.environ["FOOTFALL_SAMPLES"]) / "house/house.obj"
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([sys.executable, script, house, folder], env={**os.environ, "MPLBACKEND": "Agg"},
                                 capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual(sorted(os.listdir(folder)),
                             [f"walkthrough-{name}.png" for name in ("path", "person", "wheelchair")])
        self.assertRegex(run.stdout, r"person: \d+\.\d square units")

    def test_bounds_that_are_no_rectangle(self):
        area = two_floors()
        for bounds in ((0, 0, 1), (1, 0, 0, 1), (0, 0, 0, 1), (0, 0, float("nan"), 1), (0, 0, float("inf"), 1), 5, "a"):
            with self.subTest(bounds), self.assertRaisesRegex(
                    footfall.InputError, r"^bounds: .* is no rectangle; give \(x0, y0, x1, y1\)"):
                footfall.plot(area, bounds=bounds)

    def test_other_arguments(self):
        area = two_floors()
        with self.assertRaisesRegex(footfall.InputError, "^columns: 0 is out of range; give 1 or more"):
            footfall.plot(area, columns=0)
        with self.assertRaisesRegex(TypeError, "^columns: 'a' is not accepted; give a whole number"):
            footfall.plot(area, columns="a")
        with self.assertRaisesRegex(TypeError, "^layers: 'a' is not accepted; give whole numbers or None"):
            footfall.trimesh_dict(area, "a")

    def plotted(self, mesh, **options):
        """The axes of a plot by a stand-in for matplotlib, and the triangles that each of them got."""
        pyplot = unittest.mock.MagicMock()
        made = []

        def subplots(rows, columns, **_options):
            axes = np.empty((rows, columns), object)
            for i in range(axes.size):
                axes.flat[i] = unittest.mock.MagicMock()
            made.append(axes)
            return unittest.mock.MagicMock(), axes

        pyplot.subplots = subplots
        package = unittest.mock.MagicMock(pyplot=pyplot)
        with unittest.mock.patch.dict("sys.modules", {"matplotlib": package, "matplotlib.pyplot": pyplot}):
            footfall.plot(mesh, **options)
        return [(axis, axis.tripcolor.call_args) for axis in made[0].flat]

    def test_bounds(self):
        area = two_floors()
        vertices = np.asarray(area.vertices)
        for axis, call in self.plotted(area, bounds=(6, 0, 10, 10)):
            axis.set_xlim.assert_called_once_with(6, 10)
            axis.set_ylim.assert_called_once_with(0, 10)
            if call is not None:
                self.assertTrue((vertices[call.args[2]][:, :, 0].max(axis=1) >= 6).all())
                self.assertEqual((call.kwargs["vmin"], call.kwargs["vmax"]), (0, 1e-9))  # the upper floor is outside
        self.assertEqual(sum(call is not None for _, call in self.plotted(area, bounds=(6, 0, 10, 10))), 1)
        self.assertEqual(sum(call is not None for _, call in self.plotted(area, bounds=(50, 50, 60, 60))), 0)
        for axis, call in self.plotted(area):
            axis.set_xlim.assert_not_called()
            self.assertIsNotNone(call)

    def test_a_mesh_of_one_point(self):
        point = footfall.NavigationMesh([(1, 1, 1)], [(0, 0, 0)])
        with np.errstate(all="raise"):
            self.plotted(point, bounds=(0, 0, 1, 1))
            self.plotted(point)
            self.plotted(footfall.walkable_area(*scenes.floor(), minimum_area=1000), bounds=(0, 0, 1, 1))

    @unittest.skipIf(importlib.util.find_spec("matplotlib"), "matplotlib is installed")
    def test_without_matplotlib(self):
        with self.assertRaisesRegex(ImportError, "python3-matplotlib"):
            footfall.plot(two_floors())


if __name__ == "__main__":
    unittest.main()
