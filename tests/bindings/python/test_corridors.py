# SPDX-License-Identifier: GPL-3.0-or-later
"""The corridor map: widths, bottlenecks, ways for a body."""

import json
import unittest

import footfall
import numpy as np
import scenes


class Corridors(unittest.TestCase):
    def setUp(self):
        # Two rooms of 4 x 4 with a passage of width 1 between them.
        self.area = footfall.walkable_area(*scenes.together(
            scenes.floor(0, 0, 4, 4), scenes.floor(4, 1, 6, 2), scenes.floor(6, 0, 10, 4)))
        self.map = self.area.corridors()

    def test_bottlenecks(self):
        self.assertEqual(len(self.map.bottlenecks), 1)
        door = self.map.bottlenecks[0]
        self.assertGreater(self.map.prominence(door), 0.5)
        self.assertAlmostEqual(door.width, 1)
        self.assertAlmostEqual(door.place[1], 1.5)
        self.assertEqual(sorted(np.round([door.left[1], door.right[1]], 9)), [1, 2])
        self.assertTrue(door.is_only_way)
        self.assertAlmostEqual(sum(door.areas), 34)
        self.assertIn("width 1.0", repr(door))

    def test_arrays(self):
        count = len(self.map.places)
        self.assertEqual((self.map.places.shape, self.map.widths.shape), ((count, 3), (count,)))
        edges = self.map.edges
        self.assertLess(edges.max(), count)
        self.assertEqual((self.map.edge_widths.shape, self.map.narrowest.shape), ((len(edges),), (len(edges), 3)))
        self.assertTrue((self.map.edge_widths <= self.map.widths[edges].min(axis=1) + 1e-9).all())
        self.assertGreater(len(self.area.corridors(full=True).edges), len(edges))

    def test_ways(self):
        narrow = self.map.shortest((1, 2, 0), (9, 2, 0))
        self.assertAlmostEqual(narrow.width, 1)
        self.assertEqual(len(narrow.points), len(narrow.vertices))
        self.assertEqual(len(narrow.edges), len(narrow.vertices) - 1)
        self.assertIsNone(self.map.shortest((1, 2, 0), (9, 2, 0), 1.5))
        self.assertAlmostEqual(self.map.widest((1, 2, 0), (9, 2, 0)).width, 1)
        with self.assertRaisesRegex(footfall.InputError, "^width: "):
            self.map.shortest((1, 2, 0), (9, 2, 0), -1)

    def test_texts(self):
        self.assertIn("bottlenecks", json.loads(self.map.to_json()))
        self.assertEqual(json.loads(self.map.to_geojson())["type"], "FeatureCollection")

    def test_nothing_walkable(self):
        nothing = footfall.walkable_area(*scenes.floor(), minimum_area=1000).corridors()
        self.assertEqual((nothing.bottlenecks, nothing.places.shape, nothing.edges.shape), ([], (0, 3), (0, 2)))
        with self.assertRaisesRegex(footfall.InputError, "^start: the map has no places"):
            nothing.widest((0, 0, 0), (1, 1, 0))


if __name__ == "__main__":
    unittest.main()
