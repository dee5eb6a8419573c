# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in: what is taken, and what each wrong one is told. Arrays out: views that live as long as they are used."""

import gc
import unittest

import footfall
import numpy as np
import scenes


class ArraysIn(unittest.TestCase):
    def setUp(self):
        self.vertices, self.triangles = scenes.floor()

    def area(self, vertices, triangles):
        return footfall.walkable_area(vertices, triangles).area

    def test_types_and_layouts_that_mean_the_same(self):
        vertices, triangles = self.vertices, self.triangles
        wide = np.zeros((4, 6))
        wide[:, ::2] = vertices
        for name, v, t in [
            ("lists", vertices.tolist(), triangles.tolist()),
            ("float32", vertices.astype(np.float32), triangles),
            ("integers", vertices.astype(np.int64), triangles),
            ("other byte order", vertices.astype(">f8"), triangles.astype(">u4")),
            ("int32", vertices, triangles.astype(np.int32)),
            ("int64", vertices, triangles.astype(np.int64)),
            ("uint64", vertices, triangles.astype(np.uint64)),
            ("uint8", vertices, triangles.astype(np.uint8)),
            ("columns first", np.asfortranarray(vertices), np.asfortranarray(triangles)),
            ("strides", wide[:, ::2], np.repeat(triangles, 2, axis=0)[::2]),
            ("backwards", vertices[::-1], 3 - triangles),
        ]:
            with self.subTest(name):
                self.assertEqual(self.area(v, t), 100.0)

    def test_what_is_wrong_is_told(self):
        vertices, triangles = self.vertices, self.triangles
        not_a_number, infinite = vertices.copy(), vertices.copy()
        not_a_number[2, 1], infinite[3, 0] = np.nan, -np.inf
        give_vertices = "; give an array of shape \\(n, 3\\) and type float64"
        give_triangles = "; give an array of shape \\(m, 3\\) and type uint32"
        for name, v, t, message in [
            ("two columns", vertices[:, :2], triangles, "^vertices: the shape is \\(4, 2\\)" + give_vertices),
            ("one row", vertices[0], triangles, "^vertices: the shape is \\(3,\\)" + give_vertices),
            ("scalar", 3, triangles, "^vertices: the shape is \\(\\)" + give_vertices),
            ("empty", np.empty((0, 3)), triangles, "^vertices: there are no rows; give one at least$"),
            ("empty list", [], triangles, "^vertices: the shape is \\(0,\\)" + give_vertices),
            ("None", None, triangles, "^vertices: a NoneType is no array of numbers" + give_vertices),
            ("ragged", [[0, 0, 0], [1, 1]], triangles, "^vertices: a list is no array of numbers" + give_vertices),
            ("text", [["a", "b", "c"]], triangles, "^vertices: the type is <U1" + give_vertices),
            ("complex", vertices * 1j, triangles, "^vertices: the type is complex128" + give_vertices),
            ("long double", vertices.astype(np.longdouble), triangles, "^vertices: the type is float128" + give_vertices),
            ("objects", vertices.astype(object), triangles, "^vertices: the type is object" + give_vertices),
            ("NaN", not_a_number, triangles, "^vertices\\[2\\]: a coordinate is nan; give finite numbers$"),
            ("infinity", infinite, triangles, "^vertices\\[3\\]: a coordinate is -inf; give finite numbers$"),
            ("quads", vertices, [[0, 1, 2, 3]], "^triangles: the shape is \\(1, 4\\)" + give_triangles),
            ("flat", vertices, triangles.ravel(), "^triangles: the shape is \\(6,\\)" + give_triangles),
            ("no triangles", vertices, np.empty((0, 3), int), "^triangles: there are no rows; give one at least$"),
            ("real numbers", vertices, triangles * 1.0, "^triangles: the type is float64" + give_triangles),
            ("truth values", vertices, triangles > 0, "^triangles: the type is bool" + give_triangles),
            ("too large", vertices, triangles + 1, "^triangles\\[1\\]: there is no vertex 4; give numbers from 0 to 3$"),
            ("negative", vertices, [[0, 1, 2], [0, -1, 2]],
             "^triangles\\[1\\]: there is no vertex -1; give numbers from 0 to 3$"),
            ("huge", vertices, np.array([[0, 1, 2**64 - 1]], np.uint64),
             "^triangles\\[0\\]: there is no vertex 18446744073709551615; give numbers from 0 to 3$"),
            ("beyond 32 bits", vertices, np.array([[0, 1, 2**32 + 2]]),
             "^triangles\\[0\\]: there is no vertex 4294967298; give numbers from 0 to 3$"),
        ]:
            with self.subTest(name), self.assertRaisesRegex(footfall.InputError, message):
                footfall.walkable_area(v, t)

    def test_other_arguments_that_are_wrong(self):
        for arguments, message in [
            ({"slope": 90}, "slope"),
            ({"slope": float("nan")}, "slope"),
            ({"height": 0}, "height|clearance"),
            ({"minimum_area": -1}, "area"),
            ({"step": -1}, "step"),
            ({"up": "w"}, "^up: \"w\" is no axis; give \"z\""),
            ({"metres_per_unit": 0}, "scale|metres"),
            ({"threads": -1}, "^threads: -1 is out of range; give 0 to 1024"),
            ({"obstacle_only": [True]}, "^obstacle_only: the shape is \\(1,\\); give an array of shape \\(2,\\) and type bool$"),
            ({"obstacle_only": [0, 1]}, "^obstacle_only: the type is int64; give"),
        ]:
            with self.subTest(arguments), self.assertRaisesRegex(footfall.InputError, message):
                footfall.walkable_area(self.vertices, self.triangles, **arguments)
        with self.assertRaisesRegex(TypeError, "^progress: is not callable"):
            footfall.walkable_area(self.vertices, self.triangles, progress=3)

    def test_errors_are_python_errors(self):
        self.assertTrue(issubclass(footfall.InputError, ValueError))
        self.assertTrue(issubclass(footfall.RunError, RuntimeError))

    def test_arrays_are_copied(self):
        level = footfall.Environment(self.vertices, self.triangles)
        self.vertices[0] = 99
        self.assertEqual(level.vertices[0].tolist(), [0, 0, 0])

    def test_obstacles_only_and_both_sides(self):
        vertices, triangles = self.vertices, self.triangles
        self.assertEqual(footfall.walkable_area(vertices, triangles, obstacle_only=[True, False]).area, 50.0)
        upside_down = triangles[:, ::-1]
        self.assertEqual(footfall.walkable_area(vertices, upside_down).area, 0.0)
        self.assertEqual(footfall.walkable_area(vertices, upside_down, both_sides=True).area, 100.0)

    def test_up_axes_turn_to_z_and_back(self):
        # One floor, written for each up axis.
        frames = {
            "z": lambda v: v,
            "y": lambda v: v[:, [0, 2, 1]] * (1, 1, -1),
            "x": lambda v: v[:, [2, 0, 1]] * (1, -1, -1),
            "-y": lambda v: v[:, [0, 2, 1]] * (1, -1, 1),
            "-z": lambda v: v * (1, -1, -1),
            "-x": lambda v: v[:, [2, 0, 1]] * (-1, 1, -1),
        }
        for up, turned in frames.items():
            with self.subTest(up):
                level = footfall.Environment(turned(self.vertices), self.triangles, up=up)
                self.assertEqual(level.up, up)
                np.testing.assert_array_equal(level.vertices, self.vertices)


class ArraysOut(unittest.TestCase):
    def setUp(self):
        vertices, triangles = scenes.together(scenes.floor(), scenes.box(4, 4, 0, 6, 6, 1))
        self.area = footfall.walkable_area(vertices, triangles)

    def test_shapes_and_types(self):
        area = self.area
        n, m = len(area.vertices), len(area.triangles)
        for name, shape, kind in [
            ("vertices", (n, 3), np.float64),
            ("triangles", (m, 3), np.uint32),
            ("layers", (m,), np.uint32),
            ("source_triangles", (m,), np.uint32),
            ("obstacle_edges", (len(area.obstacle_edges), 2), np.uint32),
            ("connections", (len(area.connections), 2), np.uint32),
            ("links", (0, 4), np.uint32),
            ("link_heights", (0,), np.float64),
            ("link_widths", (0,), np.float64),
            ("link_is_gap", (0,), np.bool_),
            ("drops", (0, 4), np.uint32),
            ("drop_places", (0, 4, 3), np.float64),
            ("drop_depths", (0,), np.float64),
        ]:
            with self.subTest(name):
                array = getattr(area, name)
                self.assertEqual(array.shape, shape)
                self.assertEqual(array.dtype, kind)
        self.assertLess(area.triangles.max(), n)
        self.assertEqual(area.layer_count, area.layers.max() + 1)

    def test_drops_lead_down(self):
        vertices, triangles = scenes.together(scenes.floor(), scenes.box(4, 4, 0, 6, 6, 1))
        pipeline = [("SlopeFilter", 45), ("VerticalClearanceFilter", 2), ("DropFilter", 1, 0)]
        area = footfall.run(footfall.Environment(vertices, triangles), pipeline)
        self.assertEqual(len(area.drops), 4)
        np.testing.assert_array_equal(area.drop_depths, 1)
        np.testing.assert_array_equal(area.drop_places[:, :2], area.vertices[area.drops[:, :2]])
        np.testing.assert_array_equal(area.drop_places[:, 2:, :2], area.drop_places[:, :2, :2])
        np.testing.assert_array_equal(area.drop_places[:, 2:, 2], 0)
        np.testing.assert_array_equal(area.vertices[area.triangles[area.drops[:, 2]], 2], 1)
        np.testing.assert_array_equal(area.vertices[area.triangles[area.drops[:, 3]], 2], 0)
        statistics = area.statistics()
        self.assertEqual((statistics["drops"], statistics["drop_length"], statistics["deepest_drop"]), (4, 8, 1))
        self.assertEqual((statistics["components_below_largest"], statistics["components_above_largest"]), (0, 1))
        path = area.find_path((5, 5, 1), (1, 1, 0))
        self.assertTrue(path.reached)
        self.assertEqual(len(path.drops), 1)
        i = path.drops[0]
        self.assertEqual((path.points[i, 2], path.points[i + 1, 2]), (1, 0))
        back = area.find_path((1, 1, 0), (5, 5, 1))
        self.assertTrue(back.leads_back and not back.reached)
        other = footfall.run(footfall.Environment(vertices, triangles), pipeline[:2])
        self.assertEqual(other.statistics()["deepest_drop"], None)
        self.assertTrue(footfall.compare(area, area).equal_drops)
        self.assertFalse(footfall.compare(area, other).equal_drops)

    def test_steps_are_links(self):
        vertices, triangles = scenes.together(scenes.floor(), scenes.box(4, 4, 0, 6, 6, 0.25))
        area = footfall.walkable_area(vertices, triangles)
        self.assertEqual(len(area.links), 4)
        np.testing.assert_array_equal(area.link_heights, 0.25)
        places = area.vertices
        np.testing.assert_array_equal(places[area.links[:, 0], :2], places[area.links[:, 3], :2])
        np.testing.assert_array_equal(places[area.links[:, 1], :2], places[area.links[:, 2], :2])
        self.assertEqual(area.statistics()["links"], 4)
        self.assertEqual(len(footfall.walkable_area(vertices, triangles, step=0.2).links), 0)
        self.assertEqual(len(footfall.walkable_area(vertices, triangles, step=0).links), 0)

    def test_views_are_no_copies_and_cannot_be_written_to(self):
        for owner, name in [(self.area, "vertices"), (self.area, "triangles"), (self.area.environment, "vertices")]:
            with self.subTest(name):
                view = getattr(owner, name)
                address = view.__array_interface__["data"][0]
                self.assertEqual(getattr(owner, name).__array_interface__["data"][0], address)
                self.assertFalse(view.flags.owndata)
                with self.assertRaises(ValueError):
                    view[0] = 0
                with self.assertRaises(ValueError):
                    view.flags.writeable = True

    def test_views_outlive_what_they_came_from(self):
        views = [self.area.vertices, self.area.triangles, self.area.layers, self.area.environment.vertices]
        components = self.area.components()
        views.append(components.of_triangle)
        views.append(self.area.find_path((1, 1, 0), (9, 9, 0)).points)
        copies = [view.copy() for view in views]
        del self.area, components
        gc.collect()
        # What would have been freed is written over.
        filler = [np.full(view.shape, 77.0) for view in views for _ in range(50)]
        for view, copy in zip(views, copies):
            np.testing.assert_array_equal(view, copy)
        self.assertEqual(len(filler), 50 * len(views))

    def test_nothing_walkable_gives_empty_arrays(self):
        area = footfall.walkable_area(*scenes.floor(), minimum_area=1000)
        self.assertEqual(area.vertices.shape, (0, 3))
        self.assertEqual(area.triangles.shape, (0, 3))
        self.assertEqual(area.area, 0.0)
        self.assertEqual(len(area.components()), 0)
        self.assertEqual(area.find_path((1, 1, 0), (2, 2, 0)).status, "nothing_walkable")
        self.assertEqual(area.find_path((1, 1, 0), (2, 2, 0)).points.shape, (0, 3))


if __name__ == "__main__":
    unittest.main()
