# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong arguments: one sentence that names the argument and says what is accepted."""

import unittest

import footfall
import numpy as np
import scenes


class Arguments(unittest.TestCase):
    def setUp(self):
        self.level = footfall.Environment(*scenes.floor())
        self.area = footfall.run(self.level)

    def assert_told(self, kind, pattern, call):
        with self.assertRaisesRegex(kind, pattern) as caught:
            call()
        self.assertNotIn("\n", str(caught.exception))
        self.assertNotIn("incompatible", str(caught.exception))

    def test_unknown_keywords(self):
        self.assert_told(TypeError, r"^run\(\): there is no argument 'radius'; it is a number of an agent: give "
                         r"footfall.Agent\(radius=0.3\) as the pipeline$", lambda: footfall.run(self.level, radius=.3))
        self.assert_told(TypeError, r"^load\(\): there is no argument 'scale'; give path, up, metres_per_unit, ",
                         lambda: footfall.load("a.obj", scale=2))
        self.assert_told(TypeError, r"^Agent\(\): there is no argument 'size'; give slope, height, ",
                         lambda: footfall.Agent(size=2))
        self.assert_told(TypeError, r"^NavigationMesh.components\(\): there is no argument 'part'; it takes none",
                         lambda: self.area.components(part=2))
        self.assert_told(TypeError, r"^WalkableArea.why\(\): there is no argument 'at'; give point, triangle",
                         lambda: self.area.why(at=(0, 0, 0)))

    def test_numbers_of_arguments(self):
        self.assert_told(TypeError, r"^run\(\): 3 arguments are given by place, and 2 are accepted; give threads, cache, "
                         "progress by name$", lambda: footfall.run(self.level, None, 4))
        self.assert_told(TypeError, r"^run\(\): the argument 'environment' is missing; give environment, ",
                         lambda: footfall.run())
        self.assert_told(TypeError, r"^run\(\): the argument 'environment' is given twice",
                         lambda: footfall.run(self.level, environment=self.level))
        self.assert_told(TypeError, r"^NavigationMesh.layer\(\): the argument 'number' is missing",
                         lambda: self.area.layer())

    def test_types(self):
        for pattern, call in [
            (r"run\(\): environment: a str is not accepted; give a footfall.Environment", lambda: footfall.run("a.obj")),
            (r"run\(\): threads: a str is not accepted; give a whole number", lambda: footfall.run(self.level, threads="4")),
            (r"run\(\): threads: 1.5 is not accepted; give a whole number", lambda: footfall.run(self.level, threads=1.5)),
            (r"run\(\): cache: a dict is not accepted; give a footfall.ResultCache or None",
             lambda: footfall.run(self.level, cache={})),
            (r"Agent\(\): slope: a str is not accepted; give a number", lambda: footfall.Agent("45")),
            (r"Agent\(\): height: None is not accepted; give a number", lambda: footfall.Agent(height=None)),
            (r"load\(\): path: 5 is not accepted; give the name of a file", lambda: footfall.load(5)),
            (r"load\(\): grid: None is not accepted; give a number or a text",
             lambda: footfall.load("a.obj", grid=None)),
            (r"load\(\): limits: a str is not accepted; give True or False",
             lambda: footfall.load("a.obj", limits="no")),
            (r"load\(\): up: 2 is not accepted; give a text or None", lambda: footfall.load("a.obj", up=2)),
            (r"run\(\): environment: None is not accepted; give a footfall.Environment", lambda: footfall.run(None)),
            (r"EditableEnvironment\(\): environment: None is not accepted; give a footfall.Environment",
             lambda: footfall.EditableEnvironment(None)),
            (r"compare\(\): b: an Environment is not accepted; give a footfall.NavigationMesh",
             lambda: footfall.compare(self.area, self.level)),
            (r"compare\(\): b: None is not accepted; give a footfall.NavigationMesh",
             lambda: footfall.compare(self.area, None)),
            (r"NavigationMesh.layer\(\): number: a str is not accepted; give a whole number",
             lambda: self.area.layer("0")),
            (r"NavigationMesh.polygons\(\): part: a str is not accepted; give a whole number or None",
             lambda: self.area.polygons("0")),
            (r"Pipeline\[...\]: a str is not accepted; give a whole number", lambda: self.area.pipeline["a"]),
            (r"WalkableArea.save\(\): scale: a str is not accepted; give a number",
             lambda: self.area.save("a.obj", scale="2")),
        ]:
            with self.subTest(pattern):
                self.assert_told(TypeError, "^" + pattern, call)

    def test_numbers_out_of_range(self):
        whole = "give a whole number from 0 to 2147483647"
        for pattern, call in [
            (r"run\(\): threads: this number is not accepted; " + whole, lambda: footfall.run(self.level, threads=10**30)),
            ("threads: -1 is out of range; give 0 to 1024", lambda: footfall.run(self.level, threads=-1)),
            ("threads: 2147483647 is out of range; give 0 to 1024",
             lambda: footfall.run(self.level, threads=2147483647)),
            (r"ResultCache\(\): capacity: -1 is not accepted; " + whole, lambda: footfall.ResultCache(-1)),
            (r"WalkableArea.why\(\): triangle: -1 is not accepted; " + whole,
             lambda: self.area.why((1, 1, 1), triangle=-1)),
            (r"NavigationMesh.layer\(\): number: -1 is not accepted; " + whole, lambda: self.area.layer(-1)),
            ("there is no layer 7; give a number from 0 to 0", lambda: self.area.layer(7)),
            (r"NavigationMesh.random_places\(\): count: -1 is not accepted; " + whole,
             lambda: self.area.random_places(-1)),
            ("count: 2000000000 places are too many; give 1000000000 at most",
             lambda: self.area.random_places(2 * 10**9)),
            (r"NavigationMesh.random_places\(\): seed: -5 is not accepted; " + whole,
             lambda: self.area.random_places(1, -5)),
            (r"Agent\(\): radius: this number is not accepted; give a number that a float can hold",
             lambda: footfall.Agent(radius=10**400)),
            ("agent: radius -1 is out of range; give a number of at least 0, in metres$",
             lambda: footfall.Agent(radius=-1)),
            ("agent: gap -1 is out of range; give a number of at least 0, in metres$",
             lambda: footfall.Agent(step=0, gap=-1)),
            ("agent: height is not a finite number; give a number above 0, in metres$",
             lambda: footfall.Agent(height=float("inf"))),
            (r"point: an array of shape \(2,\) and type int64 is not accepted; give three numbers: x, y and z$",
             lambda: self.area.why((1, 2))),
            ("reach: ", lambda: self.area.find_path((1, 1, 0), (2, 2, 0), reach=-1)),
            ("part: there is no connected part 1; give a number from 0 to 0", lambda: self.area.polygons(1)),
            ("part: there is no connected part -1; ", lambda: self.area.polygons(-1)),
        ]:
            with self.subTest(pattern):
                self.assert_told(footfall.InputError, "^" + pattern, call)

    def test_errors_of_others_stay_as_they_are(self):
        def report(step, name, fraction):
            raise TypeError("mine(): incompatible ideas")

        with self.assertRaisesRegex(TypeError, "^mine"):
            footfall.run(self.level, "SlopeFilter 45", progress=report)
        with self.assertRaisesRegex(TypeError, "^progress: is not callable"):
            footfall.run(self.level, progress=5)

    def test_numpy_numbers_are_numbers(self):
        self.assertEqual(footfall.Agent(np.float32(45), np.int64(2)), footfall.Agent())
        self.assertEqual(len(self.area.random_places(np.int32(3))), 3)


if __name__ == "__main__":
    unittest.main()
