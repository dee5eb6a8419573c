# SPDX-License-Identifier: GPL-3.0-or-later
"""Places, rays, many paths, layers and polygons, and reports of comparisons."""

import importlib.util
import os
import tempfile
import unittest
import unittest.mock
import warnings

import footfall
import numpy as np
import scenes

try:
    import shapely.geometry
except ImportError:
    shapely = None

SAMPLE = os.path.join(os.environ["FOOTFALL_SAMPLES"], "house", "house.obj")


def wall():
    """A thin wall across most of the floor, from the front to y = 8."""
    return np.array([[5, 0, 0], [5, 8, 0], [5, 8, 1], [5, 0, 1]], dtype=float), scenes.QUAD


class Ground(unittest.TestCase):
    def setUp(self):
        self.area = footfall.walkable_area(*scenes.together(scenes.floor(), wall(), scenes.floor(0, 0, 4, 4, 3)))
        self.nothing = footfall.walkable_area(*scenes.floor(), minimum_area=1000)

    def test_places(self):
        place = self.area.nearest_place((12, 5, 0))
        np.testing.assert_array_equal(place.position, (10, 5, 0))
        self.assertEqual(place.distance, 2.0)
        self.assertTrue(self.area.why(place.position).is_walkable)
        self.assertEqual(self.area.place_at((1, 1, 1)).position[2], 0)
        self.assertEqual(self.area.place_at((1, 1, 2.9)).position[2], 3)
        self.assertIsNone(self.area.place_at((12, 5, 0)))
        self.assertIsNone(self.area.place_at((8, 5, 9), reach=1))
        self.assertIsNone(self.nothing.nearest_place((0, 0, 0)))
        self.assertIsNone(self.nothing.place_at((0, 0, 0)))
        with self.assertRaisesRegex(footfall.InputError, "^point"):
            self.area.nearest_place((0, float("nan"), 0))

    def test_random_places(self):
        places = self.area.random_places(4000, seed=3)
        self.assertEqual((places.shape, places.dtype, places.flags.writeable), ((4000, 3), np.float64, True))
        self.assertAlmostEqual((places[:, 2] == 3).mean(), 16 / 116, delta=0.03)
        np.testing.assert_array_equal(self.area.random_places(10, 3), places[:10])
        self.assertFalse((self.area.random_places(10, 4)[:, 0] == places[:10, 0]).any())
        self.assertEqual(self.area.random_places(0).shape, (0, 3))
        for place in places[:50]:
            self.assertIsNotNone(self.area.place_at(place, reach=0))
        with self.assertRaisesRegex(footfall.InputError, "nothing is walkable"):
            self.nothing.random_places(1)

    def test_rays(self):
        ray = self.area.cast_ray((1, 5, 0), (9, 5, 0))
        self.assertFalse(ray.reached)
        np.testing.assert_array_equal(ray.end, (5, 5, 0))
        np.testing.assert_array_equal(ray.border[:, 0], (5, 5))
        self.assertEqual(ray.plan_length, 4.0)
        self.assertEqual(len(ray.triangles), len(set(ray.triangles)))
        free = self.area.cast_ray((1, 9, 0), (9, 9, 0))
        self.assertTrue(free.reached)
        self.assertIsNone(free.border)
        self.assertEqual(repr(free), "<footfall.Ray reached: plan length 8.0>")
        self.assertIsNone(self.area.cast_ray((-1, 5, 0), (9, 5, 0)))
        self.assertIsNone(self.nothing.cast_ray((1, 5, 0), (9, 5, 0)))

    def test_rays_in_a_row(self):
        first = self.area.cast_ray((1, 5, 0), (5, 5, 0))
        self.assertEqual((first.end_place.position[0], first.start_place.triangle), (5, first.triangles[0]))
        back = self.area.cast_ray_from(first.end_place, (1, 9, 0))
        self.assertTrue(back.reached)
        np.testing.assert_array_equal(back.start, (5, 5, 0))
        # The place lies on a wall without thickness, and the ray stays on its side.
        self.assertFalse(self.area.cast_ray_from(first.end_place, (9, 5, 0)).reached)
        self.assertFalse(self.area.cast_ray_from(back.start_place, (9, 5, 0)).reached)
        right = self.area.cast_ray((9, 5, 0), (5, 5, 0)).end_place
        self.assertTrue(self.area.cast_ray_from(right, (9, 5, 0)).reached)
        self.assertEqual(self.area.cast_ray((1, 5, 0), (9, 5, 0)).end_place.distance, 4.0)
        with self.assertRaisesRegex(TypeError, r"cast_ray_from\(\): place: a tuple is not accepted; give a footfall.Place"):
            self.area.cast_ray_from((1, 5, 0), (9, 5, 0))
        other = footfall.NavigationMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        with self.assertRaisesRegex(footfall.InputError, "place does not lie in triangle 0; give a place of this mesh"):
            other.cast_ray_from(self.area.layer(1).nearest_place((3, 3, 3)), (1, 1, 0))

    def test_many_paths(self):
        places = self.area.random_places(40)
        paths = self.area.find_paths(places[:-1], places[1:])
        for path, start, target in zip(paths, places, places[1:]):
            one = self.area.find_path(start, target)
            np.testing.assert_array_equal(path.points, one.points)
            self.assertEqual((path.status, path.length), (one.status, one.length))
        self.assertEqual(len(self.area.find_paths((1, 1, 0), places)), 40)
        self.assertEqual(len(self.area.find_paths(places, places[0])), 40)
        self.assertEqual(self.area.find_paths([], []), [])
        self.assertEqual(self.nothing.find_paths((1, 1, 0), (2, 2, 0))[0].status, "nothing_walkable")
        with self.assertRaisesRegex(footfall.InputError, "^targets: there are 3 for 40 starts; give as many, or one"):
            self.area.find_paths(places, places[:3])
        with self.assertRaisesRegex(footfall.InputError, "^starts"):
            self.area.find_paths("here", places)

    def test_a_mesh_keeps_its_path_finder(self):
        level = footfall.run(footfall.load(SAMPLE))
        with unittest.mock.patch("footfall.NavigationMesh.components", side_effect=AssertionError):
            first = level.find_path((1, 1, 0), (2, 2, 0))
            again = level.find_path((1, 1, 0), (2, 2, 0))
        self.assertEqual(first.length, again.length)

    def test_layers(self):
        self.assertEqual(self.area.layer_count, 2)
        areas = [self.area.layer(i).components().total_area for i in range(2)]
        self.assertAlmostEqual(sum(areas), 116)
        upper = self.area.layer(int(self.area.layers[np.asarray(self.area.vertices)[self.area.triangles[:, 0], 2] == 3][0]))
        self.assertEqual(set(upper.vertices[:, 2]), {3.0})
        self.assertEqual(upper.components().total_area, 16)
        with self.assertRaisesRegex(footfall.InputError, "the mesh has no layers"):
            footfall.NavigationMesh(*scenes.floor()).layer(0)

    def test_components_are_a_list(self):
        parts = self.area.components()
        self.assertIsInstance(parts, list)
        self.assertEqual([part.area for part in parts], [100.0, 16.0])
        self.assertEqual([part.area for part in parts[:1]], [100.0])
        self.assertEqual(parts.total_area, 116.0)
        self.assertEqual(list(reversed(parts))[0].area, 16.0)
        self.assertEqual(len(parts.of_triangle), len(self.area.triangles))
        self.assertEqual(self.nothing.components(), [])
        self.assertEqual(self.nothing.components().total_area, 0)

    @unittest.skipUnless(shapely, "shapely is not installed (python3-shapely)")
    def test_polygons(self):
        polygons = self.area.polygons()
        self.assertEqual([polygon.area for polygon in polygons], [100.0, 16.0])
        self.assertTrue(all(polygon.is_valid for polygon in polygons))
        self.assertEqual([p.area for p in self.area.polygons(1)], [16.0])
        self.assertEqual([p.area for p in self.area.polygons(part=np.int64(0))], [100.0])
        table = footfall.walkable_area(*scenes.together(scenes.floor(), scenes.box(4, 4, 0, 6, 6, 1)))
        self.assertEqual([len(p.interiors) for p in table.polygons()], [1, 0])
        self.assertEqual(self.nothing.polygons(), [])
        for part in (2, -1):
            with self.assertRaisesRegex(footfall.InputError, f"^part: there is no connected part {part}; give a number"):
                self.area.polygons(part)
        with self.assertRaisesRegex(footfall.InputError, "nothing is walkable"):
            self.nothing.polygons(0)

    def test_without_packages(self):
        with unittest.mock.patch.dict("sys.modules", {"shapely": None, "shapely.geometry": None, "trimesh": None}):
            with self.assertRaisesRegex(ImportError, r"polygons\(\) needs shapely; install it \(python3-shapely\)"):
                self.area.polygons()
            with self.assertRaisesRegex(ImportError, r"to_trimesh\(\) needs trimesh; install it"):
                self.area.to_trimesh()

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "trimesh is not installed")
    def test_trimesh(self):
        self.assertAlmostEqual(self.area.to_trimesh().area, 116)
        np.testing.assert_array_equal(self.area.to_trimesh().faces, self.area.triangles)
        self.assertAlmostEqual(sum(self.area.to_trimesh(i).area for i in range(2)), 116)

    def test_one_point_and_no_area(self):
        for mesh in (footfall.NavigationMesh([(1, 1, 1)], [(0, 0, 0)]),
                     footfall.NavigationMesh([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertIsNone(mesh.nearest_place((0, 0, 0)))
                self.assertEqual(mesh.find_path((1, 1, 1), (1, 1, 1)).status, "nothing_walkable")
                self.assertIn("<table>", mesh._repr_html_())
                self.assertEqual(mesh.components().total_area, 0)
                str(footfall.compare(mesh, mesh))
                if shapely:
                    self.assertEqual(mesh.polygons(), [])
            with self.assertRaises(footfall.InputError):
                mesh.random_places(1)


class Reports(unittest.TestCase):
    def test_one_area_inside_another(self):
        small = footfall.run(footfall.Environment(*scenes.floor(0, 0, 4, 4), name="small"))
        large = footfall.run(footfall.Environment(*scenes.floor(), name="large"))
        comparison = footfall.compare(small, large)
        self.assertEqual((comparison.exact_only_a, comparison.exact_only_b, comparison.exact_both), (0, 84, 16))
        self.assertEqual((comparison.uncovered_a, comparison.uncovered_b), (0, 84))
        self.assertEqual((comparison.a.uncovered_area, comparison.b.uncovered_area), (0, 84))
        text = str(comparison)
        self.assertIn("A: walkable area of small: 2 triangles, area 16\n", text)
        self.assertIn("B: walkable area of large: 2 triangles, area 100\n", text)
        self.assertIn("B holds all of A, exactly, and more", text)
        self.assertIn("exact: area in A only 0, in B only 84, in both 16", text)
        self.assertIn("area of A that B does not cover 0, of B that A does not cover 84", text)
        self.assertEqual(repr(comparison),
                         "<footfall.Comparison of walkable area of small with walkable area of large: different>")

    def test_areas_of_one_level_are_told_apart(self):
        level = footfall.Environment(*scenes.floor(), name="hall")
        thin, wide = footfall.run(level, [footfall.Agent(), footfall.Agent(radius=0.5)])
        text = str(footfall.compare(thin, wide))
        self.assertRegex(text, r"A: walkable area of hall \(slope 45 degrees, height 2[^)]*\): 2 triangles")
        self.assertRegex(text, r"B: walkable area of hall \(.*radius 0\.5[^)]*\): ")
        self.assertIn("A: walkable area of hall: ", str(footfall.compare(thin, footfall.run(level))))

    def test_older_names_still_work(self):
        mesh = footfall.NavigationMesh(*scenes.floor())
        comparison = footfall.compare(mesh, mesh)
        for older, newer in (("only_a", "exact_only_a"), ("only_b", "exact_only_b"), ("both", "exact_both")):
            with self.assertWarnsRegex(DeprecationWarning, "use Comparison." + newer):
                self.assertEqual(getattr(comparison, older), getattr(comparison, newer))
        self.assertIn("A: mesh of arrays: 2 triangles", str(comparison))
        self.assertIn("Equal", str(comparison))

    def test_tables_for_notebooks(self):
        level = footfall.Environment(*scenes.floor(), name="<a&b>")
        area = footfall.run(level)
        for thing in (level, area, area.layer(0), area.pipeline, footfall.compare(area, area)):
            text = thing._repr_html_()
            self.assertTrue(text.startswith("<table>") and text.endswith("</table>"), text)
            self.assertNotIn("<a&b>", text)
        self.assertIn("Environment &lt;a&amp;b&gt;", level._repr_html_())
        self.assertIn("100", area._repr_html_())


class Limits(unittest.TestCase):
    def test_limits_of_readers_are_an_option(self):
        # A reader that takes a little more memory than any small file may, and then fails.
        with tempfile.TemporaryDirectory() as folder:
            reader, level = os.path.join(folder, "reader"), os.path.join(folder, "level.off")
            with open(reader, "w") as file:
                file.write("#!/usr/bin/env python3\nimport sys, time\nheld = bytearray(1100 << 20)\n"
                           "held[::4096] = b'x' * len(held[::4096])\ntime.sleep(3)\nsys.exit(3)\n")
            os.chmod(reader, 0o700)
            with open(level, "w") as file:
                file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            with unittest.mock.patch.dict(os.environ, {"FOOTFALL_IMPORT": reader}):
                with self.assertRaisesRegex(footfall.InputError, "exit status 3"):
                    footfall.load(level, limits=False)
                with self.assertRaisesRegex(footfall.InputError, "memory"):
                    footfall.load(level)


if __name__ == "__main__":
    unittest.main()
