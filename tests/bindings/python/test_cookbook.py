# SPDX-License-Identifier: GPL-3.0-or-later
"""The code of the cookbook runs, from its first line to its last, on files by the names that it uses."""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap
import unittest

import footfall

PAGE = pathlib.Path(__file__).parents[3] / "docs/how-to/python_cookbook.md"
SAMPLE = pathlib.Path(os.environ["FOOTFALL_SAMPLES"]) / "house/house.obj"
PACKAGES = {"matplotlib": "footfall.plot", "trimesh": "to_trimesh", "pandas": "pandas", "shapely": "polygons("}


def blocks():
    """Indented code of the page: (heading, code)."""
    found, heading, lines = [], "the beginning", []
    for line in PAGE.read_text().split("\n") + ["the end"]:
        if line.startswith("    ") or (not line and lines):
            lines.append(line)
            continue
        if lines:
            found.append((heading, textwrap.dedent("\n".join(lines))))
            lines = []
        if line.startswith("#"):
            heading = line.lstrip("# ")
    return found


def adapted(code):
    """The code with the sample under the names that it reads, and without lines of packages that are not here."""
    code = re.sub(r'"(level\.glb|level\.obj|building\.ifc)"', repr(str(SAMPLE)), code)
    missing = [word for package, word in PACKAGES.items() if importlib.util.find_spec(package) is None]
    return "\n".join(line for line in code.split("\n") if not any(word in line for word in missing))


class Cookbook(unittest.TestCase):
    def test_the_page_has_code(self):
        self.assertGreater(len(blocks()), 15)

    def test_all_code_runs_in_its_order(self):
        given = "import numpy as np\nvertices = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0]])\ntriangles = [[0, 1, 2]]\n"
        program = given + "\n".join(f"\n# {heading}\n{adapted(code)}" for heading, code in blocks())
        with tempfile.TemporaryDirectory() as folder:
            footfall.run(footfall.load(SAMPLE)).save(os.path.join(folder, "before.obj"))
            run = subprocess.run([sys.executable, "-W", "error::DeprecationWarning", "-c", program], cwd=folder,
                                 env={**os.environ, "MPLBACKEND": "Agg"}, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr + program)
        self.assertIn("A: mesh of before.obj", run.stdout)


if __name__ == "__main__":
    unittest.main()
