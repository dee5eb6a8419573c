"""The page, its plots and its pictures from made-up figures: python3 test_page.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import pathlib
import struct
import tempfile
import unittest
import zlib

import make_page
import plan_picture
from markdown_html import to_html
from svg_plot import line_plot, ticks_of


def entry(kind, depth, points):
    """Figures of the communication benchmark."""
    return {"format": kind, "depth": depth, "points": points, "bytes": 24 * points, "write_ms": 2.0, "read_ms": 1.0,
            "write_mb_s": 3.0, "read_mb_s": 4.0, "thesis": {"write_ms": 9.0, "read_ms": 0.0}}


class TestPage(unittest.TestCase):
    """Each test would fail if what it names were left out."""

    def test_markdown(self):
        text = to_html("### Head\n\n| a | b |\n|---|--:|\n| x<y | *z* |\n\nSome `code`.")
        self.assertIn("<h3>Head</h3>", text)
        self.assertIn("<td>x&lt;y</td><td class=r><i>z</i></td>", text)
        self.assertIn("<code>code</code>", text)

    def test_plots_say_where_processors_end(self):
        plot = line_plot("t", "threads", "S", [("one", [(1, 1), (32, 2)], 0, "line")], 2, False, 2, "two; they take turns")
        self.assertIn(">they take turns<", plot)
        self.assertIn(">32<", plot)
        without = line_plot("t", "threads", "S", [("one", [(1, 1), (2, 2)], 0, "line")], 2, False, 2, "they take turns")
        self.assertNotIn("they take turns", without)

    def test_ticks(self):
        self.assertEqual(ticks_of(1, 1e6, True, 10), [1, 10, 100, 1e3, 1e4, 1e5, 1e6])
        self.assertEqual(ticks_of(1, 32, True, 2), [1, 2, 4, 8, 16, 32])

    def test_the_higher_triangle_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "two.obj"
            path.write_text("v 0 0 5\nv 4 0 5\nv 0 4 5\nv 0 0 1\nv 4 0 1\nv 0 4 1\ng a\nf 1 2 3\ng b\nf 4 5 6\n")
            png = plan_picture.draw(path, False)
        width, height = struct.unpack(">II", png[16:24])
        self.assertEqual((width, height), (plan_picture.SIZE, plan_picture.SIZE))
        start = png.index(b"IDAT")
        length = struct.unpack(">I", png[start - 4 : start])[0]
        rows = zlib.decompress(png[start + 4 : start + 4 + length])
        row = 500
        at = row * (3 * width + 1) + 1 + 3 * 100
        self.assertEqual(tuple(rows[at : at + 3]), plan_picture.PALETTE[0])

    def test_a_page_of_what_there_is(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "communication.json").write_text(json.dumps(
                {"peak_bytes": 5e6, "entries": [entry("ascii", 1, n) for n in (1, 1000, 1000000)]}))
            (folder / "communication.md").write_text("| points |\n|---|\n| 1,000,000 |\n")
            page = make_page.Page(folder).sections()
        self.assertIn("<td>1,000,000</td>", page)
        self.assertIn("Writing, ms (thesis)", page)
        self.assertIn("thesis.json was not measured", page)
        self.assertIn("partition-*.png: no picture was made", page)


if __name__ == "__main__":
    unittest.main()
