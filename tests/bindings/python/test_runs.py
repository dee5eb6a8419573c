# SPDX-License-Identifier: GPL-3.0-or-later
"""Pipelines, runs, edits with a cache, paths, places and comparisons, on scenes with known answers."""

import pickle
import unittest

import footfall
import numpy as np
import scenes


class Pipelines(unittest.TestCase):
    def test_text_and_steps_are_the_same(self):
        text = footfall.Pipeline("SlopeFilter 40\n# a comment\nVerticalClearanceFilter 1.8\nAutoStrategy\nCollapse\n")
        steps = footfall.Pipeline([("SlopeFilter", 40), "VerticalClearanceFilter 1.8", ("AutoStrategy",), "Collapse"])
        self.assertEqual(text, steps)
        self.assertEqual(hash(text), hash(steps))
        self.assertEqual(len(steps), 4)
        self.assertEqual(steps[0], ("SlopeFilter", 40.0, 0.01))
        self.assertEqual(steps[-1], ("Collapse",))
        self.assertEqual([step[0] for step in steps],
                         ["SlopeFilter", "VerticalClearanceFilter", "AutoStrategy", "Collapse"])
        self.assertEqual(footfall.Pipeline(str(steps)), steps)
        self.assertEqual(footfall.Pipeline(list(steps)), steps)
        self.assertEqual(pickle.loads(pickle.dumps(steps)), steps)
        self.assertNotEqual(steps, footfall.Pipeline("SlopeFilter 41"))

    def test_values_that_repeat(self):
        pipeline = footfall.Pipeline([("ReachableFilter", 1, 1, 0, *np.array([2.5, 3, 0.5]))])
        self.assertEqual(pipeline[0], ("ReachableFilter", 1.0, 1.0, 0.0, 2.5, 3.0, 0.5))
        self.assertEqual(str(pipeline), "ReachableFilter 1 1 0 2.5 3 0.5\n")
        reachable = next(f for f in footfall.filters() if f.name == "ReachableFilter")
        self.assertEqual((reachable.repeats, [p.name for p in reachable.parameters]), (3, ["x", "y", "z"]))
        with self.assertRaisesRegex(footfall.InputError, "^pipeline:1:23: .*values given: 4"):
            footfall.Pipeline([("ReachableFilter", 1, 1, 0, 2)])
        with self.assertRaisesRegex(footfall.InputError, "ReachableFilter has no seed"):
            footfall.Pipeline(["ReachableFilter"])

    def test_numbers_and_truth_values(self):
        step = footfall.Pipeline([("SmartRecursiveStrategy", 50, 3, True), "Collapse"])[0]
        self.assertEqual(step[1:], (50, 3, True))
        self.assertIs(type(step[1]), int)
        self.assertIs(step[3], True)

    def test_what_is_wrong_is_told(self):
        for steps, message in [
            ("SlopeFiler 45", "^pipeline:1:1: .*SlopeFiler"),
            (["DegeneracyFilter", ("SlopeFilter",)], "^pipeline:2:"),
            ([("SlopeFilter", 95)], "^pipeline:1:.*95"),
            ([("SlopeFilter", "steep")], "^pipeline:1:.*steep"),
            ([45], "^pipeline: an int is not accepted as a step; give"),
            (45, "^pipeline: an int is not accepted; give a footfall.Pipeline, its text, or a list of steps"),
        ]:
            with self.subTest(steps), self.assertRaisesRegex(footfall.InputError, message):
                footfall.Pipeline(steps)
        with self.assertRaisesRegex(footfall.InputError, "^missing.pipeline: "):
            footfall.read_pipeline("missing.pipeline")

    def test_an_agent_in_place_of_its_numbers(self):
        feet = footfall.Environment(*scenes.floor(), metres_per_unit=0.5)
        agent = footfall.Agent(slope=30, height=1.5, step=0.25, gap=0.1, radius=0.3, minimum_area=2)
        pipeline = feet.pipeline_for(slope=30, height=1.5, step=0.25, gap=0.1, radius=0.3, minimum_area=2)
        self.assertEqual(feet.pipeline_for(agent=agent), pipeline)
        self.assertEqual(footfall.run(feet, agent).pipeline, pipeline)
        self.assertEqual(footfall.walkable_area(*scenes.floor(), metres_per_unit=0.5, agent=agent).pipeline, pipeline)
        self.assertEqual(feet.pipeline_for(agent=footfall.Agent()), feet.pipeline_for())
        for call in (lambda: feet.pipeline_for(height=3, agent=agent),
                     lambda: footfall.walkable_area(*scenes.floor(), step=0.2, agent=agent)):
            with self.assertRaisesRegex(footfall.InputError, "^agent: .* give either an agent or such numbers"):
                call()
        with self.assertRaisesRegex(footfall.InputError, "^agent: a str is not accepted; give a footfall.Agent"):
            feet.pipeline_for(agent="Human")

    def test_agents_are_values(self):
        agent = footfall.Agent(40, 1.5, 0.2, 0.1, 0.3)
        self.assertEqual((agent.slope, agent.height, agent.step, agent.gap, agent.radius, agent.minimum_area),
                         (40, 1.5, 0.2, 0.1, 0.3, 1))
        self.assertEqual(eval(repr(agent)), agent)
        self.assertEqual(pickle.loads(pickle.dumps(agent)), agent)
        self.assertEqual(len({agent, footfall.Agent(40, 1.5, 0.2, 0.1, 0.3), footfall.Agent()}), 2)
        with self.assertRaises(AttributeError):
            agent.slope = 30
        for name, value in [("slope", 90), ("slope", 0), ("height", 0), ("step", -1), ("gap", -1), ("radius", -0.1),
                            ("minimum_area", float("nan"))]:
            with self.subTest(name), self.assertRaisesRegex(footfall.InputError, "^agent: "):
                footfall.Agent(**{name: value})

    def test_known_agents(self):
        known = footfall.agents()
        self.assertEqual(known["Unity"], footfall.Agent(step=0.75, radius=0.5))
        self.assertEqual(known["Wheelchair"].slope, 5)
        level = footfall.Environment(*scenes.floor())
        for name, agent in known.items():
            with self.subTest(name):
                self.assertGreater(footfall.run(level, agent).area, (10 - 2.03 * agent.radius) ** 2)

    def test_agents_are_in_metres(self):
        vertices, triangles = scenes.floor()
        feet = footfall.Environment(vertices, triangles, metres_per_unit=0.5)
        steps = dict((step[0], step[1:]) for step in feet.pipeline_for(slope=30, height=1.5, minimum_area=2))
        self.assertEqual(steps["SlopeFilter"], (30.0, 0.01))
        self.assertEqual(steps["VerticalClearanceFilter"], (3.0,))
        self.assertEqual(steps["AreaFilter"], (8.0,))
        self.assertEqual(steps["StepFilter"], (0.8, 0.1))
        names = [step[0] for step in feet.pipeline_for(step=0.25)]
        self.assertEqual(names[3:6], ["VerticalClearanceFilter", "StepFilter", "AreaFilter"])
        self.assertEqual(feet.pipeline_for(step=0.25)[4], ("StepFilter", 0.5, 0.1))
        self.assertEqual(feet.pipeline_for(gap=0.25)[4], ("StepFilter", 0.8, 0.5))
        self.assertNotIn("StepFilter", [step[0] for step in feet.pipeline_for(step=0)])
        self.assertIn("RadiusFilter", [step[0] for step in feet.pipeline_for(radius=0.3)])
        self.assertEqual(feet.pipeline_for(drop=1.5)[-1], ("DropFilter", 3.0, 0.6))

    def test_filters_are_described(self):
        slope = {f.name: f for f in footfall.filters()}["SlopeFilter"]
        self.assertEqual([p.name for p in slope.parameters], ["max_slope", "tolerance"])
        self.assertEqual((slope.parameters[0].unit, slope.parameters[0].default), ("degrees", 45.0))
        self.assertTrue(slope.is_local)
        self.assertEqual(slope.kind, "filter")


class Runs(unittest.TestCase):
    def setUp(self):
        # A table of 2 x 2 in a room of 10 x 10: nobody of 2 m stands under it.
        self.soup = scenes.together(scenes.floor(), scenes.box(4, 4, 0.9, 6, 6, 1))
        self.level = footfall.Environment(*self.soup)

    def test_default_pipeline_is_the_default_agent(self):
        a, b = footfall.run(self.level), footfall.walkable_area(*self.soup)
        np.testing.assert_array_equal(a.vertices, b.vertices)
        np.testing.assert_array_equal(a.triangles, b.triangles)
        self.assertEqual(a.area, 100.0)  # 96 of the floor, 4 on the table
        self.assertIs(a.environment, self.level)
        self.assertEqual(a.pipeline, self.level.pipeline_for())

    def test_agents(self):
        self.assertEqual(footfall.walkable_area(*self.soup, height=0.5).area, 104.0)
        self.assertEqual(footfall.walkable_area(*self.soup, height=0.9).area, 104.0)
        self.assertEqual(footfall.walkable_area(*self.soup, minimum_area=4).area, 96.0)
        self.assertEqual(footfall.walkable_area(*self.soup, metres_per_unit=4).area, 104.0)

    def test_layers(self):
        area = footfall.walkable_area(*self.soup, height=0.5)
        self.assertEqual(area.layer_count, 2)
        heights = area.vertices[area.triangles][:, :, 2].max(axis=1)
        for layer in range(2):
            self.assertEqual(len(set(heights[area.layers == layer] > 0.5)), 1)
        self.assertIsNone(footfall.run(self.level, "SlopeFilter 45").layers)

    def test_components(self):
        components = footfall.walkable_area(*self.soup).components()
        self.assertEqual([c.area for c in components], [96.0, 4.0])
        self.assertEqual(components[1].lower.tolist(), [4, 4, 1])
        self.assertEqual(components[-1].upper.tolist(), [6, 6, 1])
        self.assertEqual(components.total_area, 100.0)
        self.assertEqual(sorted(set(components.of_triangle.tolist())), [0, 1])
        with self.assertRaises(IndexError):
            components[2]

    def test_statistics(self):
        area = footfall.run(self.level, [("SlopeFilter", 45), ("VerticalClearanceFilter", 2)], threads=1)
        statistics = area.statistics()
        self.assertEqual([step["name"] for step in statistics["steps"]], ["SlopeFilter", "VerticalClearanceFilter"])
        self.assertEqual(statistics["steps"][1]["area_in"], 104.0)
        self.assertEqual(statistics["steps"][1]["area_out"], 100.0)
        self.assertEqual(statistics["threads"], 1)
        self.assertEqual([component["area"] for component in statistics["components"]], [96.0, 4.0])
        self.assertEqual((statistics["links"], statistics["highest_link"]), (0, None))
        self.assertAlmostEqual(statistics["connected_share"], 0.96**2 + 0.04**2)
        self.assertIn("VerticalClearanceFilter", str(area))
        self.assertRegex(repr(area), "^<footfall.WalkableArea of arrays: \\d+ vertices")

    def test_progress_names_each_step_in_order(self):
        seen = []
        footfall.run(self.level, progress=lambda step, name, fraction: seen.append((step, name, fraction)))
        names = [step[0] for step in self.level.pipeline_for()]
        done = dict.fromkeys((step, name) for step, name, fraction in seen if fraction == 1)
        self.assertEqual(list(done), list(enumerate(names)))
        self.assertTrue(all(0 <= fraction <= 1 for _, _, fraction in seen))

    def test_an_area_is_made_by_runs_only(self):
        with self.assertRaisesRegex(TypeError, "No constructor"):
            footfall.WalkableArea(*scenes.floor())


class Edits(unittest.TestCase):
    def test_obstacles_come_move_and_go(self):
        level = footfall.EditableEnvironment(footfall.Environment(*scenes.floor()))
        cache = footfall.ResultCache()
        empty = level.environment

        def area():
            edited = footfall.run(level.environment, cache=cache)
            fresh = footfall.run(footfall.Environment(level.environment.vertices, level.environment.triangles))
            np.testing.assert_array_equal(edited.vertices, fresh.vertices)
            np.testing.assert_array_equal(edited.triangles, fresh.triangles)
            return edited

        self.assertEqual(area().area, 100.0)
        table = level.add(*scenes.box(1, 1, 0.5, 3, 3, 1))
        crate = level.add(*scenes.box(6, 6, 0, 7, 8, 1))
        self.assertEqual([c.area for c in area().components()], [94.0, 4.0, 2.0])
        level.replace(table, *scenes.box(3, 4, 2, 6, 5, 3))
        self.assertEqual([c.area for c in area().components()], [98.0, 3.0, 2.0])
        level.remove(crate)
        self.assertEqual(area().area, 103.0)
        self.assertEqual(len(empty.triangles), 2)
        with self.assertRaisesRegex(footfall.InputError, "there is no obstacle"):
            level.remove(crate)
        with self.assertRaisesRegex(footfall.InputError, "^vertices\\[0\\]: a coordinate is nan"):
            level.add(np.full((3, 3), np.nan), [[0, 1, 2]])
        self.assertEqual(area().area, 103.0)

    def test_paths_after_an_edit(self):
        level = footfall.EditableEnvironment(footfall.Environment(*scenes.floor()))
        cache = footfall.ResultCache()
        before = footfall.run(level.environment, cache=cache)
        before.prepare_paths()
        level.add(*scenes.box(4, 2, 0, 6, 8, 3))
        after = footfall.run(level.environment, cache=cache)
        after.prepare_paths(before=before)
        anew = footfall.run(level.environment)
        self.assertGreater(after.find_path((2, 5, 0), (8, 5, 0)).length, 6)
        np.testing.assert_array_equal(
            after.find_path((2, 5, 0), (8, 5, 0)).points, anew.find_path((2, 5, 0), (8, 5, 0)).points
        )
        self.assertEqual(before.find_path((2, 5, 0), (8, 5, 0)).length, 6)
        anew.prepare_paths(before=before)  # it is prepared already
        with self.assertRaises(TypeError):
            after.prepare_paths(before=3)

    def test_several_agents(self):
        level = footfall.Environment(*scenes.floor(0, 0, 10, 4))
        agents = [footfall.Agent(), footfall.Agent(radius=0.5), footfall.Agent(radius=1, drop=1), footfall.Agent()]
        areas = footfall.run(level, agents)
        self.assertEqual([type(area) for area in areas], [footfall.WalkableArea] * 4)
        for agent, area in zip(agents, areas):
            alone = footfall.run(level, agent)
            self.assertEqual(area.pipeline, alone.pipeline)
            self.assertEqual(area.vertices.tobytes(), alone.vertices.tobytes())
            self.assertEqual(area.triangles.tobytes(), alone.triangles.tobytes())
            self.assertTrue(area.why((2, 2, 0)).is_walkable)
        computed = [sum(not step["from_cache"] for step in area.statistics()["steps"]) for area in areas]
        self.assertEqual((computed[0], computed[3]), (len(areas[0].pipeline), 0))
        self.assertTrue(0 < computed[1] < len(areas[1].pipeline))
        self.assertEqual(areas[1].statistics()["start_ms"], 0)

    def test_several_agents_with_options(self):
        level, cache, seen = footfall.Environment(*scenes.floor(0, 0, 10, 4)), footfall.ResultCache(), []
        agents = (footfall.Agent(), footfall.Agent(radius=0.5))
        footfall.run(level, agents, threads=1, cache=cache, progress=lambda *event: seen.append(event))
        again = footfall.run(level, agents[1], cache=cache)
        self.assertTrue(all(step["from_cache"] for step in again.statistics()["steps"]))
        with self.assertRaisesRegex(footfall.InputError, r"^pipeline\[1\]: a str is not accepted among agents; give a foot"):
            footfall.run(level, [footfall.Agent(), "SlopeFilter 45"])
        for nothing in ([], ()):
            with self.assertRaisesRegex(footfall.InputError, "^pipeline: the list is empty; give a step or an agent"):
                footfall.run(level, nothing)
        with self.assertRaisesRegex(footfall.InputError, "^threads: -1"):
            footfall.run(level, agents, threads=-1)

        def stop(step, name, fraction):
            raise KeyError(name)

        with self.assertRaises(KeyError):
            footfall.run(footfall.Environment(*scenes.slow(1500)), agents,
                         progress=stop)

    def test_the_cache_is_used(self):
        level, cache = footfall.Environment(*scenes.floor()), footfall.ResultCache(capacity=16)
        self.assertGreater(footfall.run(level, cache=cache).statistics()["start_ms"], 0)
        self.assertEqual(footfall.run(level, cache=cache).statistics()["start_ms"], 0)
        cache.clear()
        self.assertGreater(footfall.run(level, cache=cache).statistics()["start_ms"], 0)


class Paths(unittest.TestCase):
    def test_around_a_box(self):
        area = footfall.walkable_area(*scenes.together(scenes.floor(), scenes.box(4, 0, 0, 6, 8, 3)))
        path = area.find_path((1, 1, 0), (9, 1, 0))
        self.assertTrue(path.reached)
        self.assertEqual(path.message, "")
        self.assertAlmostEqual(path.plan_length, 2 * np.hypot(3, 7) + 2, places=12)
        self.assertEqual(path.points[0].tolist(), [1, 1, 0])
        self.assertEqual(path.points[-1].tolist(), [9, 1, 0])
        self.assertEqual(path.points[path.bends].tolist(), [[4, 8, 0], [6, 8, 0]])
        self.assertEqual(len(path.triangles), len(path.points) - 1)
        self.assertEqual(path.start.tolist(), [1, 1, 0])
        self.assertIsNone(path.separation)
        self.assertIsNone(path.barrier)

    def test_what_separates(self):
        area = footfall.walkable_area(*scenes.together(scenes.floor(), scenes.floor(10.25, 0, 20, 10, 0.5)))
        path = area.find_path((1, 1, 0), (15, 1, 0.5))
        self.assertEqual(path.status, "not_connected")
        self.assertFalse(path.reached)
        self.assertEqual(len(path.separation), 1)
        self.assertEqual((path.barrier.kind, path.barrier.gap, path.barrier.rise), ("open", 0.25, 0.5))
        self.assertEqual(path.barrier.size, 0.5)
        self.assertFalse(path.barrier.is_blocked)
        self.assertIn("0.5", path.message)
        self.assertEqual(path.end[0], 10.0)
        self.assertIn(path.message, str(path))

    def test_what_is_missing_beyond_a_step(self):
        level = footfall.Environment(*scenes.together(scenes.floor(), scenes.floor(10, 0, 20, 10, 0.5)))
        area = footfall.run(level, ["SlopeFilter 45", "VerticalClearanceFilter 2", "StepFilter 0.375"])
        path = area.find_path((1, 1, 0), (15, 1, 0.5))
        self.assertEqual((path.barrier.rise, path.barrier.excess), (0.5, 0.125))
        self.assertEqual((path.barrier.triangles, path.other_ways), ([], []))
        self.assertIn("a step of 0.5 up, 0.125 too high", path.message)
        area = footfall.run(level, ["SlopeFilter 45", "VerticalClearanceFilter 2", "StepFilter 0.5"])
        path = area.find_path((1, 1, 0), (15, 1, 0.5))
        self.assertTrue(path.reached)
        self.assertIsNone(path.other_ways)

    def test_places_that_are_not_walkable(self):
        area = footfall.walkable_area(*scenes.floor())
        self.assertEqual(area.find_path((-1, 0, 0), (1, 1, 0)).status, "start_not_walkable")
        self.assertEqual(area.find_path((1, 1, 0), (-1, 0, 0)).status, "target_not_walkable")
        self.assertEqual(area.find_path((1, 1, 3), (2, 2, 0)).status, "start_not_walkable")
        self.assertEqual(area.find_path((1, 1, 3), (2, 2, 0), reach=3).status, "found")
        for point, message in [((1, 2), "^start: .*shape \\(2,\\)"), ("here", "^start: "), ((1, np.nan, 0), "^start: .*finite")]:
            with self.subTest(point), self.assertRaisesRegex(footfall.InputError, message):
                area.find_path(point, (1, 1, 0))
        with self.assertRaisesRegex(footfall.InputError, "^reach: "):
            area.find_path((1, 1, 0), (2, 2, 0), reach=-1)

    def test_on_a_mesh_of_another_program(self):
        mesh = footfall.NavigationMesh(*scenes.floor(), layers=[0, 1])
        path = mesh.find_path((1, 2, 0), (9, 3, 0))
        self.assertAlmostEqual(path.length, np.hypot(8, 1), places=12)
        self.assertEqual(path.layers, [1, 0])
        self.assertEqual(mesh.layer_count, 2)
        self.assertIsNone(mesh.source_triangles)


class Places(unittest.TestCase):
    def test_why(self):
        ramp = np.array([[20, 0, 0], [21, 0, 2], [21, 5, 2], [20, 5, 0]], dtype=float), scenes.QUAD
        soup = scenes.together(scenes.floor(), scenes.box(4, 4, 0.9, 6, 6, 1), ramp, scenes.floor(30, 0, 30.5, 1))
        level = footfall.Environment(*soup)
        for cache in (None, footfall.ResultCache()):
            area = footfall.run(level, cache=cache)
            self.assertEqual(area.why((1, 1, 0)).verdict, "walkable")
            self.assertTrue(area.why((1, 1, 5)).is_walkable)
            self.assertEqual(area.why((1, 1, 0)).component, 0)
            low = area.why((5, 5, 0.5))
            self.assertEqual((low.verdict, low.filter, low.limit), ("too_low", "VerticalClearanceFilter", 2.0))
            self.assertEqual(area.pipeline[low.step][0], low.filter)
            self.assertEqual(low.obstacle[0], 0.9)
            self.assertEqual(low.point.tolist(), [5, 5, 0])
            self.assertIsNone(low.component)
            self.assertIn("0.9", str(low))
            steep = area.why((20.5, 1, 2))
            self.assertEqual((steep.verdict, steep.filter), ("too_steep", "SlopeFilter"))
            self.assertAlmostEqual(steep.slope, np.degrees(np.arctan(2)))
            small = area.why((30.25, 0.5, 0))
            self.assertEqual((small.verdict, small.region_area), ("region_too_small", 0.5))
            self.assertEqual(area.why((5, 5, 0.95), triangle=2).verdict, "faces_down")
            with self.assertRaisesRegex(footfall.InputError, "^point: nothing is at or under it"):
                area.why((-5, 0, 0))
            with self.assertRaises(footfall.InputError):
                area.why((1, 1, 0), triangle=len(level.triangles))


    def test_what_cannot_be_reached_goes(self):
        soup = scenes.together(scenes.floor(), scenes.floor(20, 0, 25, 10), scenes.floor(2, 2, 4, 4, 5))
        level = footfall.Environment(*soup)
        steps = ["VerticalClearanceFilter 2"]
        self.assertEqual(footfall.run(level, steps).components().total_area, 154)
        area = footfall.run(level, [*steps, ("ReachableFilter", 1, 1, 0)])
        self.assertEqual(area.components().total_area, 100)
        gone = area.why((22, 1, 0.5))
        self.assertEqual((gone.verdict, gone.filter, gone.limit), ("unreachable", "ReachableFilter", 0.0))
        self.assertIn("cannot be reached from the seeds", str(gone))
        with self.assertRaisesRegex(footfall.InputError, "line 2, ReachableFilter: column 23: seed 2 at 15 1 0"):
            footfall.run(level, [*steps, ("ReachableFilter", 1, 1, 0, 15, 1, 0)])


class Comparisons(unittest.TestCase):
    def test_same_points_whatever_their_triangles(self):
        vertices, triangles = scenes.floor()
        a = footfall.NavigationMesh(vertices, triangles)
        b = footfall.NavigationMesh(vertices, [[0, 1, 3], [1, 2, 3]])
        comparison = footfall.compare(a, b)
        self.assertTrue(comparison.equal)
        self.assertEqual((comparison.exact_only_a, comparison.exact_only_b, comparison.exact_both), (0, 0, 100.0))
        self.assertEqual(comparison.covered, 1.0)
        self.assertEqual(comparison.a_to_b.max, 0.0)

    def test_what_one_has_and_the_other_has_not(self):
        a = footfall.walkable_area(*scenes.floor())
        b = footfall.walkable_area(*scenes.floor(2, 0, 10, 10, 0.125))
        comparison = footfall.compare(a, b, height=0.125)
        self.assertFalse(comparison.equal)
        self.assertEqual(comparison.a.uncovered_area, 20.0)
        self.assertEqual(comparison.b.uncovered_area, 0.0)
        self.assertAlmostEqual(comparison.covered, 0.8)
        self.assertAlmostEqual(comparison.area_ratio, 0.8)
        self.assertAlmostEqual(comparison.a_to_b.max, np.hypot(2, 0.125))
        lower, upper = comparison.b_to_a.hausdorff
        self.assertLessEqual(lower, 0.125)
        self.assertGreaterEqual(upper, 0.125)
        with self.assertRaises(footfall.InputError):
            footfall.compare(a, b, height=-1)

    def test_steps(self):
        soup = scenes.together(scenes.floor(0, 0, 2, 4, 0), scenes.floor(2, 0, 4, 4, 0.25))
        level = footfall.Environment(*soup)
        filters = ["SlopeFilter 45", "VerticalClearanceFilter 2"]
        without, with_steps = footfall.run(level, filters), footfall.run(level, filters + ["StepFilter 0.25"])
        comparison = footfall.compare(without, with_steps)
        self.assertTrue(comparison.equal)
        self.assertFalse(comparison.equal_links)
        self.assertEqual(comparison.link_lengths, [0.0, 4.0, 0.0])
        self.assertEqual((comparison.a.components, comparison.b.components), (2, 1))


if __name__ == "__main__":
    unittest.main()
