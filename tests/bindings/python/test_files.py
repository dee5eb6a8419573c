# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in and out: what Python saves is what `footfall run` writes, byte for byte."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import footfall
import numpy as np
import scenes

PROGRAM = os.environ["FOOTFALL_PROGRAM"]
SAMPLES = sorted(pathlib.Path(os.environ["FOOTFALL_SAMPLES"]).glob("*/*.obj"))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written_by_program(self, *arguments, ending):
        target = self.folder / ("program" + ending)
        subprocess.run([PROGRAM, "run", *arguments, "--quiet", "-o", target], check=True)
        return target.read_bytes()

    def test_samples_give_the_bytes_of_the_program(self):
        self.assertGreaterEqual(len(SAMPLES), 2)
        for sample in SAMPLES:
            level = footfall.load(sample)
            steps = sample.with_suffix(".pipeline")
            for pipeline in [None] + ([steps] if steps.exists() else []):
                with self.subTest(sample=sample.name, pipeline=pipeline):
                    area = footfall.run(level, footfall.read_pipeline(pipeline) if pipeline else None)
                    self.assertGreater(len(area.triangles), 0)
                    given = [] if pipeline is None else ["-p", pipeline]
                    for ending in (".obj", ".glb") if sample == SAMPLES[0] else (".obj",):
                        target = self.folder / ("python" + ending)
                        area.save(target)
                        self.assertEqual(target.read_bytes(), self.written_by_program(sample, *given, ending=ending))

    def test_options_give_the_bytes_of_the_program(self):
        sample = SAMPLES[0]
        target = self.folder / "python.obj"
        area = footfall.run(footfall.load(sample, up="-z", metres_per_unit=0.5, both_sides=True))
        area.save(target, layers=False, connections=False, obstacle_edges=False, steps=False, drops=False, up="y", scale=2)
        expected = self.written_by_program(
            sample, "--up", "-z", "--scale", "0.5", "--both-sides", "--no-layers", "--no-connections",
            "--no-obstacle-edges", "--no-steps", "--no-drops", "--export-up", "y", "--export-scale", "2", ending=".obj")
        self.assertEqual(target.read_bytes(), expected)

    def test_coordinates_on_a_grid(self):
        sample = next(s for s in SAMPLES if s.name == "rooms.obj")
        self.assertEqual(footfall.load(sample).grid_step, 0.0)
        self.assertGreater(footfall.load(sample, grid="on").grid_step, 0.0)
        self.assertEqual(footfall.load(sample, grid=0.3).grid_step, 0.25)
        self.assertEqual(footfall.load(sample, grid="off").grid_step, 0.0)
        with self.assertRaisesRegex(footfall.InputError, "coarse"):
            footfall.load(sample, grid="coarse")

    def test_formats_give_the_bytes_of_the_program(self):
        sample = next(s for s in SAMPLES if s.name == "house.obj")
        area = footfall.run(footfall.load(sample))
        for ending, options, arguments in [
                (".tres", {}, []), (".tres", {"godot": 3}, ["--godot", "3"]),
                (".gltf", {"navmesh_node": True}, ["--navmesh-node"]),
                (".geojson", {"part": 0, "coordinate_system": "EPSG:25832"}, ["--part", "1", "--crs", "EPSG:25832"])]:
            with self.subTest(ending=ending, options=options):
                target = self.folder / ("python" + ending)
                area.save(target, **options)
                self.assertEqual(target.read_bytes(), self.written_by_program(sample, *arguments, ending=ending))
        area.save(self.folder / "level.wkt")
        self.assertIn("POLYGON", (self.folder / "level-0.wkt").read_text())
        self.assertIn("MULTILINESTRING", (self.folder / "level-links.wkt").read_text())
        with self.assertRaisesRegex(footfall.InputError, "a version of Godot"):
            area.save(self.folder / "a.obj", godot=3)
        with self.assertRaisesRegex(footfall.InputError, "^part: there is no connected part 99999; give a number"):
            area.save(self.folder / "a.wkt", part=99999)
        with self.assertRaisesRegex(footfall.InputError, "no connected part 99999"):
            area.save(self.folder / "a.geojson", part=99999)

    def test_roles_give_the_bytes_of_the_program(self):
        sample = next(s for s in SAMPLES if s.name == "house.obj")
        level = footfall.load(sample)
        part = {mesh: level.part_of == i for i, (mesh, _) in enumerate(level.parts)}
        changed = level.with_roles(ignored=part["furniture"] | part["fence"], obstacle_only=part["roof"])
        self.assertEqual(len(level.triangles) - len(changed.triangles), 26)
        self.assertEqual(changed.obstacle_only.sum(), 34)
        footfall.run(changed).save(self.folder / "roles.obj")
        expected = self.written_by_program(
            sample, "--ignore", "furniture", "--ignore", "fence", "--obstacle-only", "roof", ending=".obj")
        self.assertEqual((self.folder / "roles.obj").read_bytes(), expected)
        with self.assertRaisesRegex(footfall.InputError, "^ignored: no triangle is left"):
            level.with_roles(ignored=level.part_of >= 0)

    def test_arrays_give_the_bytes_of_the_file(self):
        sample = SAMPLES[0]
        level = footfall.load(sample)
        self.assertEqual(level.up, "y")
        of_file = level.vertices[:, [0, 2, 1]] * (1, 1, -1)
        again = footfall.Environment(of_file, level.triangles, up="y", metres_per_unit=level.metres_per_unit,
                                     name=str(sample))
        np.testing.assert_array_equal(again.vertices, level.vertices)
        footfall.run(again).save(self.folder / "arrays.obj")
        self.assertEqual((self.folder / "arrays.obj").read_bytes(), self.written_by_program(sample, ending=".obj"))

    def test_what_was_written_is_read_again(self):
        area = footfall.walkable_area(*scenes.together(scenes.floor(), scenes.box(4, 4, 0.9, 6, 6, 1)), height=0.5)
        self.assertEqual(area.save(self.folder / "a.obj"), 0.0)
        mesh = footfall.read_mesh(self.folder / "a.obj")
        np.testing.assert_array_equal(mesh.layers, area.layers)
        self.assertTrue(footfall.compare(area, mesh).equal)
        self.assertGreaterEqual(area.save(self.folder / "a.glb"), 0.0)

    def test_parts(self):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\no left\nf 1 2 3\no right\nf 1 3 4\n")
        level = footfall.load(self.folder / "two.obj", up="z")
        self.assertEqual([mesh for mesh, _ in level.parts], ["left", "right"])
        self.assertEqual(level.part_of.tolist(), [0, 1])
        self.assertFalse(level.up_is_guessed)
        left = footfall.Environment(level.vertices, level.triangles[level.part_of == 0])
        self.assertEqual(footfall.run(left).area, 8.0)
        self.assertIsNone(left.part_of)

    def test_errors_name_the_file(self):
        with self.assertRaisesRegex(footfall.InputError, "nowhere.obj"):
            footfall.load(self.folder / "nowhere.obj")
        with self.assertRaisesRegex(footfall.InputError, "nowhere.obj"):
            footfall.read_mesh(self.folder / "nowhere.obj")
        area = footfall.walkable_area(*scenes.floor())
        with self.assertRaisesRegex(footfall.InputError, "\\.obj"):
            area.save(self.folder / "a.stl")
        with self.assertRaisesRegex(footfall.RunError, "nowhere"):
            area.save(self.folder / "nowhere" / "a.obj")
        with self.assertRaises(footfall.InputError):
            area.save(self.folder / "a.obj", scale=0)
        self.assertIn("obj", footfall.importable_extensions())


if __name__ == "__main__":
    unittest.main()
