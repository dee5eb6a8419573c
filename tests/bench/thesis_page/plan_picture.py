"""A cut environment or a result from above, as a PNG: each group of an OBJ file has a colour of its own.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import struct
import zlib

SIZE = 640
PALETTE = [
    (86, 180, 233), (230, 159, 0), (0, 158, 115), (204, 121, 167), (240, 228, 66), (0, 114, 178), (213, 94, 0),
    (150, 150, 150), (120, 200, 120), (190, 140, 90), (150, 120, 220), (90, 200, 200),
]


def read_obj(path, y_up):
    """Vertices with Z up, and (group number, corners) of each triangle."""
    vertices, triangles, group = [], [], -1
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            if line.startswith("v "):
                x, y, z = (float(part) for part in line.split()[1:4])
                vertices.append((x, -z, y) if y_up else (x, y, z))
            elif line.startswith("g "):
                group += 1
            elif line.startswith("f "):
                corners = [int(part.split("/")[0]) - 1 for part in line.split()[1:]]
                for k in range(2, len(corners)):
                    triangles.append((max(group, 0), (corners[0], corners[k - 1], corners[k])))
    return vertices, triangles


class Canvas:
    """Pixels with the height of what they show."""

    def __init__(self, vertices):
        xs, ys = [v[0] for v in vertices], [v[1] for v in vertices]
        self.x, self.y = min(xs), max(ys)
        self.scale = (SIZE - 1) / max(max(xs) - self.x, self.y - min(ys), 1e-9)
        self.width = int((max(xs) - self.x) * self.scale) + 1
        self.height = int((self.y - min(ys)) * self.scale) + 1
        self.depth = [-math.inf] * (self.width * self.height)
        self.pixels = bytearray(b"\xff" * (3 * self.width * self.height))

    def place(self, vertex):
        """Column, row and height of a vertex."""
        return (vertex[0] - self.x) * self.scale, (self.y - vertex[1]) * self.scale, vertex[2]

    def set(self, column, row, z, colour):
        """Colours one pixel unless something higher is there."""
        if not (0 <= column < self.width and 0 <= row < self.height):
            return
        i = row * self.width + column
        if z >= self.depth[i]:
            self.depth[i] = z
            self.pixels[3 * i : 3 * i + 3] = bytes(colour)

    def triangle(self, corners, colour):
        """Fills a triangle, row by row."""
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if abs(area) < 1e-12:
            return
        dzdx = ((bz - az) * (cy - ay) - (cz - az) * (by - ay)) / area
        dzdy = ((cz - az) * (bx - ax) - (bz - az) * (cx - ax)) / area
        sides = [(corners[k], corners[(k + 1) % 3]) for k in range(3)]
        colour = bytes(colour)
        for row in range(max(0, math.ceil(min(ay, by, cy))), min(self.height - 1, math.floor(max(ay, by, cy))) + 1):
            crossings = []
            for (px, py, _), (qx, qy, _) in sides:
                if py != qy and min(py, qy) <= row <= max(py, qy):
                    crossings.append(px + (row - py) / (qy - py) * (qx - px))
            if not crossings:
                continue
            first, last = max(0, math.ceil(min(crossings))), min(self.width - 1, math.floor(max(crossings)))
            z = az + (first - ax) * dzdx + (row - ay) * dzdy
            i = row * self.width + first
            for _ in range(first, last + 1):
                if z >= self.depth[i]:
                    self.depth[i] = z
                    self.pixels[3 * i : 3 * i + 3] = colour
                z += dzdx
                i += 1

    def edge(self, p, q, colour):
        """A line of one pixel just above what it lies on."""
        steps = int(max(abs(p[0] - q[0]), abs(p[1] - q[1]))) + 1
        for i in range(steps + 1):
            share = i / steps
            x, y, z = (p[k] + share * (q[k] - p[k]) for k in range(3))
            self.set(round(x), round(y), z + 1e-6 * (1 + abs(z)), colour)

    def png(self):
        """The picture as the bytes of a file."""
        rows = b"".join(
            b"\0" + self.pixels[3 * self.width * row : 3 * self.width * (row + 1)] for row in range(self.height)
        )

        def chunk(name, data):
            return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def shade(vertices, corners):
    """From 0.45 for what is upright to 1 for what is level."""
    a, b, c = (vertices[k] for k in corners)
    u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(sum(part * part for part in normal))
    return 0.45 + 0.55 * abs(normal[2]) / length if length > 0 else 1


def draw(path, y_up, with_edges=False):
    """The bytes of a PNG of an OBJ file from above."""
    vertices, triangles = read_obj(path, y_up)
    if not vertices:
        raise ValueError(f"{path}: no vertices")
    canvas = Canvas(vertices)
    for group, corners in triangles:
        light = shade(vertices, corners)
        colour = [int(part * light) for part in PALETTE[group % len(PALETTE)]]
        canvas.triangle([canvas.place(vertices[k]) for k in corners], colour)
    if with_edges:
        for _, corners in triangles:
            places = [canvas.place(vertices[k]) for k in corners]
            for k in range(3):
                canvas.edge(places[k], places[(k + 1) % 3], (30, 30, 30))
    return canvas.png()
