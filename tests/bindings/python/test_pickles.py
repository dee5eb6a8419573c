# SPDX-License-Identifier: GPL-3.0-or-later
"""Environments, areas, meshes and pipelines pickle and copy, also with names of files that are no UTF-8."""

import copy
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import unittest

import footfall
import numpy as np
import scenes

SAMPLE = os.path.join(os.environ["FOOTFALL_SAMPLES"], "house", "house.obj")

ARRAYS = ["vertices", "triangles", "layers", "source_triangles", "obstacle_edges", "connections", "links", "link_heights",
          "link_widths", "link_is_gap", "drops", "drop_places", "drop_depths"]


def again(thing):
    return pickle.loads(pickle.dumps(thing))


class Pickles(unittest.TestCase):
    def assert_same_mesh(self, a, b):
        for name in ARRAYS:
            np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)
        for name in ("layer_count", "source", "up", "metres_per_unit"):
            self.assertEqual(getattr(a, name), getattr(b, name))

    def assert_same_environment(self, a, b):
        for name in ("vertices", "triangles", "part_of", "obstacle_only"):
            np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)
        for name in ("source", "up", "up_is_guessed", "metres_per_unit", "scale_is_guessed", "both_sides", "grid_step",
                     "parts", "skipped_polygons"):
            self.assertEqual(getattr(a, name), getattr(b, name), name)

    def test_environments(self):
        level = footfall.load(SAMPLE, grid="on")
        self.assert_same_environment(again(level), level)
        marked = level.with_roles(obstacle_only=np.arange(len(level.triangles)) % 7 == 0)
        self.assert_same_environment(again(marked), marked)
        np.testing.assert_array_equal(footfall.run(again(marked)).vertices, footfall.run(marked).vertices)
        arrays = footfall.Environment(*scenes.floor(), up="y", metres_per_unit=0.5, both_sides=True, name="mine")
        self.assert_same_environment(again(arrays), arrays)

    def test_areas(self):
        area = footfall.run(footfall.load(SAMPLE), footfall.Agent(drop=2, gap=0.3))
        self.assertGreater(len(area.links) * len(area.drops), 0)
        other = again(area)
        self.assert_same_mesh(other, area)
        self.assert_same_environment(other.environment, area.environment)
        self.assertEqual((other.area, str(other), repr(other), other.pipeline, other.statistics()["triangles"]),
                         (area.area, str(area), repr(area), area.pipeline, area.statistics()["triangles"]))
        self.assertIs(type(other), footfall.WalkableArea)
        place = area.random_places(1)[0]
        self.assertEqual(str(other.why(place)), str(area.why(place)))
        with tempfile.TemporaryDirectory() as folder:
            for name, kept in (("a.obj", area), ("b.obj", other)):
                kept.save(os.path.join(folder, name))
            with open(os.path.join(folder, "a.obj"), "rb") as a, open(os.path.join(folder, "b.obj"), "rb") as b:
                self.assertEqual(a.read(), b.read())

    def test_a_level_is_one_level_within_a_pickle(self):
        level = footfall.Environment(*scenes.floor())
        both = again([level, footfall.run(level)])
        self.assertIs(both[1].environment, both[0])

    def test_pickles_of_pickles_are_the_same(self):
        area = again(footfall.run(footfall.load(SAMPLE)))
        self.assertEqual(pickle.dumps(again(area)), pickle.dumps(area))

    def test_meshes_layers_and_components(self):
        area = footfall.run(footfall.load(SAMPLE))
        self.assert_same_mesh(again(area.layer(0)), area.layer(0))
        mesh = footfall.NavigationMesh(*scenes.floor())
        self.assert_same_mesh(again(mesh), mesh)
        parts = again(area.components())
        self.assertEqual([p.area for p in parts], [p.area for p in area.components()])
        np.testing.assert_array_equal(parts.of_triangle, area.components().of_triangle)
        empty = footfall.walkable_area(*scenes.floor(), minimum_area=1000)
        self.assert_same_mesh(again(empty), empty)

    def test_copies(self):
        level = footfall.Environment(*scenes.floor())
        area = footfall.run(level)
        for thing in (level, area, area.layer(0)):
            self.assertIs(copy.copy(thing), thing)  # nothing of them ever changes
            self.assertIs(copy.deepcopy(thing), thing)
        for thing in (area.pipeline, footfall.Agent(slope=30)):
            self.assertEqual(copy.copy(thing), thing)
            self.assertEqual(copy.deepcopy(thing), thing)
        self.assertEqual(copy.deepcopy({"a": area})["a"].area, 100.0)

    def test_names_that_are_no_utf_8(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(os.fsencode(folder), b"caf\xe9 \xff.obj")
            shutil.copy(SAMPLE, name)
            level = footfall.load(os.fsdecode(name))
            self.assertEqual(os.fsencode(level.source), name)
            self.assertIn(r"caf\xe9 \xff.obj", repr(level))
            area = footfall.run(level)
            for text in (repr(area), str(area), level._repr_html_(), area._repr_html_(),
                         str(footfall.compare(area, area))):
                text.encode("utf-8")
            self.assertEqual(os.fsencode(area.source), name)
            self.assertGreater(area.statistics()["triangles"], 0)
            other = again(area)
            self.assertEqual((other.source, other.environment.source), (area.source, level.source))
            self.assert_same_mesh(other, area)
            self.assertIs(copy.copy(level), level)
            str(area.why(area.random_places(1)[0])).encode("utf-8")
            target = os.path.join(os.fsencode(folder), b"\xfe.obj")
            area.save(os.fsdecode(target))
            self.assertIn(r"\xfe.obj", str(footfall.compare(footfall.read_mesh(os.fsdecode(target)), area)))
            with self.assertRaisesRegex(footfall.InputError, r"none\\xff.obj"):
                footfall.load(os.fsdecode(os.path.join(os.fsencode(folder), b"none\xff.obj")))
            arrays = footfall.Environment(*scenes.floor(), name=os.fsdecode(b"\xff"))
            self.assertEqual(os.fsencode(again(arrays).source), b"\xff")

    def test_what_does_not_fit_together_is_refused(self):
        mesh = footfall.NavigationMesh(*scenes.floor())
        state = mesh.__getstate__()
        for change in ({"version": 99}, {"triangles": b"\xff" * 12}, {"vertices": b"123"}, {"layers": b"\0" * 4}):
            with self.subTest(change), self.assertRaisesRegex(footfall.InputError, "^pickle: "):
                footfall.NavigationMesh.__new__(footfall.NavigationMesh).__setstate__({**state, **change})
        level = footfall.Environment(*scenes.floor())
        with self.assertRaises(footfall.InputError):
            footfall.Environment.__new__(footfall.Environment).__setstate__(
                {**level.__getstate__(), "triangles": b"\xff" * 12})

    def test_another_process(self):
        area = footfall.run(footfall.load(SAMPLE))
        program = ("import pickle, sys; a = pickle.load(sys.stdin.buffer); "
                   "print(type(a).__name__, a.area, len(a.environment.triangles))")
        told = subprocess.run([sys.executable, "-c", program], input=pickle.dumps(area), capture_output=True, check=True)
        self.assertEqual(told.stdout.decode().split(),
                         ["WalkableArea", str(area.area), str(len(area.environment.triangles))])


if __name__ == "__main__":
    unittest.main()
