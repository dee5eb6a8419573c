# SPDX-License-Identifier: GPL-3.0-or-later
"""Small triangle soups with known answers, Z up."""

import numpy as np

QUAD = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.uint32)


def floor(x0=0.0, y0=0.0, x1=10.0, y1=10.0, z=0.0):
    """A rectangle that faces up: two triangles."""
    return np.array([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], dtype=float), QUAD


def box(x0, y0, z0, x1, y1, z1):
    """A closed box whose sides face outwards: twelve triangles."""
    corners = np.array([[x, y, z] for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)], dtype=float)
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, np.array([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))], dtype=np.uint32)


def together(*soups):
    """One soup of several."""
    vertices, triangles, count = [], [], 0
    for some_vertices, some_triangles in soups:
        vertices.append(some_vertices)
        triangles.append(some_triangles + np.uint32(count))
        count += len(some_vertices)
    return np.concatenate(vertices), np.concatenate(triangles)


def slow(count):
    """Many large triangles that cross each other."""
    random = np.random.default_rng(1)
    centres = random.uniform(0, 30, (count, 1, 3)) * (1, 1, 0.2)
    vertices = (centres + random.uniform(-4, 4, (count, 3, 3)) * (1, 1, 0.15)).reshape(-1, 3)
    triangles = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    down = np.cross(b - a, c - a)[:, 2] < 0
    triangles[down] = triangles[down][:, ::-1]
    return vertices, triangles
