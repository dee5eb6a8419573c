# Runs in Blender without a window: installs the add-on from its zip and tries what a user does. See test.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
import sys
import time
import unittest

import bpy
import numpy as np

ZIP = sys.argv[sys.argv.index("--") + 1]
bpy.ops.preferences.addon_install(filepath=ZIP, overwrite=True)
bpy.ops.preferences.addon_enable(module="footfall_blender")
import footfall  # noqa: E402
import footfall_blender as addon  # noqa: E402
from footfall_blender import job as jobs  # noqa: E402
from footfall_blender import level as levels  # noqa: E402


def add_box(name, lower, upper):
    (x0, y0, z0), (x1, y1, z1) = lower, upper
    corners = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def shown():
    return {obj[levels.RESULT]: obj for obj in bpy.data.collections["Walkable area"].objects}


def area_of(obj):
    return sum(polygon.area for polygon in obj.data.polygons)


def arrays(area):
    return [np.asarray(a) for a in (area.vertices, area.triangles, area.layers, area.links)]


class Scene(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.preferences.addon_enable(module="footfall_blender")
        add_box("ground", (0, 0, -1), (10, 10, 0))
        self.crate = add_box("crate", (4, 4, 0), (6, 6, 1))
        add_box("kerb", (8, 0, 0), (10, 10, 0.25))
        bpy.context.view_layer.update()

    def compute(self):
        self.assertEqual(bpy.ops.footfall.compute(), {"FINISHED"})
        return addon.state.area

    def test_the_area_comes_as_a_collection(self):
        area = self.compute()
        self.assertAlmostEqual(area.area, 100)  # the crate's top is as large as what it stands on
        layers = [obj for name, obj in shown().items() if name.startswith("layer_")]
        self.assertEqual(len(layers), area.layer_count)
        self.assertAlmostEqual(sum(area_of(obj) for obj in layers), 100, places=4)
        self.assertIn("steps", shown())
        self.assertAlmostEqual(area_of(shown()["steps"]), 2.5, places=4)  # the kerb's front
        self.assertTrue(all(obj.data.materials for obj in shown().values()))

    def test_results_are_no_part_of_the_level(self):
        first = arrays(self.compute())
        again = arrays(self.compute())
        self.assertTrue(all(np.array_equal(a, b) for a, b in zip(first, again)))

    def test_the_selection_counts(self):
        bpy.data.objects["ground"].select_set(True)
        self.assertAlmostEqual(self.compute().area, 100)
        self.assertEqual(addon.state.names, ["ground"])
        self.assertNotIn("steps", shown())

    def test_edits_give_the_result_of_a_fresh_run(self):
        self.compute()
        for move in ((1, 0, 0), (0, -3.5, 0.5), (20, 0, 0)):
            self.crate.location = move
            bpy.context.view_layer.update()
            edited = arrays(self.compute())
            addon.state.level = levels.Level(footfall)
            addon.state.job = jobs.Job(footfall)
            fresh = arrays(self.compute())
            # In another order of objects numbers of sources differ, but not what is walkable.
            self.assertTrue(all(np.array_equal(a, b) for a, b in zip(edited, fresh)))
        bpy.data.objects.remove(self.crate)
        addon.state.names.remove("crate")
        self.assertAlmostEqual(self.compute().area, 100)

    def test_live_follows_what_moves(self):
        bpy.context.scene.footfall_agent.is_live = True
        self.compute()
        addon.poll()
        addon.finish(bpy.context, wait=True)
        before = arrays(addon.state.area)
        bpy.context.view_layer.update()
        self.assertFalse(addon.state.is_dirty)
        self.crate.location = (1.5, 0, 0)
        bpy.context.view_layer.update()
        self.assertTrue(addon.state.is_dirty)
        addon.poll()
        self.assertTrue(addon.finish(bpy.context, wait=True))
        self.assertFalse(np.array_equal(before[0], np.asarray(addon.state.area.vertices)))

    def test_a_mirrored_object_keeps_its_fronts(self):
        bpy.data.objects["ground"].scale = (-1, 1, 1)
        bpy.data.objects["ground"].location = (10, 0, 0)
        bpy.context.view_layer.update()
        self.assertAlmostEqual(self.compute().area, 100)

    def test_modifiers_and_units_count(self):
        self.crate.modifiers.new("two", "ARRAY").relative_offset_displace = (2, 0, 0)
        bpy.context.scene.unit_settings.scale_length = 0.5  # the kerb is 0.125 m, the crates half a metre
        bpy.context.scene.footfall_agent.step = 0.1
        bpy.context.view_layer.update()
        self.compute()
        self.assertNotIn("steps", shown())
        self.assertAlmostEqual(footfall_metres(), 0.5)

    def test_why_at_the_cursor(self):
        self.compute()
        bpy.context.scene.cursor.location = (1, 1, 0.1)
        self.assertEqual(bpy.ops.footfall.why(), {"FINISHED"})
        self.assertEqual(addon.state.answer[0], "walkable")
        bpy.context.scene.cursor.location = (5, 5, 0.5)  # under the crate's top
        self.assertEqual(bpy.ops.footfall.why(), {"FINISHED"})
        self.assertNotEqual(addon.state.answer[0], "walkable")

    def test_nothing_to_walk_on_is_a_message(self):
        for obj in list(bpy.data.objects):
            bpy.data.objects.remove(obj)
        with self.assertRaisesRegex(RuntimeError, "no faces"):
            bpy.ops.footfall.compute()

    def test_what_footfall_refuses_is_a_message(self):
        self.crate.data.vertices[0].co = (float("nan"), 0, 0)
        with self.assertRaisesRegex(RuntimeError, "crate: a coordinate is not finite"):
            bpy.ops.footfall.compute()
        self.assertIn("crate", addon.state.message)

    def test_the_next_run_cancels_the_one_before(self):
        rng = np.random.default_rng(1)
        corners = rng.uniform(0, 1000, (60000, 3)) * (1, 1, 0.01)
        vertices = (corners[:, None] + rng.uniform(-5, 5, (60000, 3, 3)) * (1, 1, 0.1)).reshape(-1, 3)
        environment = footfall.Environment(vertices, np.arange(180000).reshape(-1, 3), both_sides=True)
        job = jobs.Job(footfall)
        job.start(environment, environment.pipeline_for())
        time.sleep(0.2)
        self.assertTrue(job._thread.is_alive())
        began = time.monotonic()
        job.cancel()
        took = time.monotonic() - began
        self.assertFalse(job.is_running)
        self.assertIsNone(job.take())
        print(f"cancelled after {1000 * took:.0f} ms")


def footfall_metres():
    return addon.state.level.environment.metres_per_unit


result = unittest.main(argv=["test_addon"], exit=False, verbosity=1).result
sys.exit(0 if result.wasSuccessful() else 1)
