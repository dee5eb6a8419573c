# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths for agents with a body: any radius from one corridor map."""

import math
import unittest

import footfall
import scenes


class BodyPaths(unittest.TestCase):
    def setUp(self):
        # Two rooms of 4 x 4 with a passage of width 1 between them.
        self.area = footfall.walkable_area(*scenes.together(
            scenes.floor(0, 0, 4, 4), scenes.floor(4, 1, 6, 2), scenes.floor(6, 0, 10, 4)))
        self.paths = self.area.body_paths()

    def test_found(self):
        found = self.paths.find((1, 3, 0), (9, 3, 0), 0.4)
        self.assertEqual((found.status, found.reached, found.message), ("found", True, ""))
        self.assertAlmostEqual(found.narrowest.width, 1)
        self.assertAlmostEqual(found.start_distance, 1)
        self.assertEqual((found.lacking, found.admissible), (0, None))
        # Not shorter than straight, and not much longer than the way of a point.
        point = self.area.find_path((1, 3, 0), (9, 3, 0))
        self.assertGreater(found.path.plan_length, point.plan_length)
        self.assertLess(found.path.plan_length, point.plan_length + 0.5)
        self.assertIn("narrow", str(found))
        self.assertIn("found", repr(found))
        self.assertIn("width 1.0", repr(found.narrowest))

    def test_too_narrow(self):
        stopped = self.paths.find((1, 3, 0), (9, 3, 0), 0.7)
        self.assertEqual(stopped.status, "too_narrow")
        self.assertAlmostEqual(stopped.lacking, 0.4)
        self.assertAlmostEqual(stopped.narrowest.width, 1)
        self.assertEqual(sorted([stopped.narrowest.left[1], stopped.narrowest.right[1]]), [1, 2])
        self.assertIn("too narrow", stopped.message)

    def test_too_near(self):
        near = self.paths.find((0.2, 2, 0), (9, 3, 0), 0.4)
        self.assertEqual(near.status, "start_too_near")
        self.assertAlmostEqual(near.lacking, 0.2)
        self.assertAlmostEqual(near.admissible[0], 0.4)
        self.assertAlmostEqual(near.admissible[1], 2)
        self.assertTrue(self.paths.find(near.admissible, (9, 3, 0), 0.4).reached)
        self.assertEqual(self.paths.find((1, 3, 0), (9, 3.9, 0), 0.4).status, "target_too_near")

    def test_widest(self):
        widest = self.area.body_paths().find((1, 3, 0), (9, 3, 0), 0.1, prefer_width=math.inf)
        self.assertAlmostEqual(widest.narrowest.width, 1)
        with self.assertRaises(footfall.InputError):
            self.paths.find((1, 3, 0), (9, 3, 0), 0)
        with self.assertRaises(footfall.InputError):
            self.paths.find((1, 3, 0), (9, 3, 0), math.nan)
        with self.assertRaises(footfall.InputError):
            self.paths.find((1, 3, 0), (9, 3, 0), 1, prefer_width=-1)


if __name__ == "__main__":
    unittest.main()
