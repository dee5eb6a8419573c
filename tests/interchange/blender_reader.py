# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's own importers find in exports: `blender -b --python blender_reader.py -- OBJ GLTF...`.

Prints a line "read back: JSON": for each file its layers with their areas, and its connected parts with their areas and
areas in the plan, largest first.
"""

import collections
import json
import sys

import bpy
import numpy

if not hasattr(numpy, "bool"):  # which Blender 3.4's importer of glTF asks for, and Debian's numpy has no more
    numpy.bool = bool


def area_of(a, b, c):
    return ((b - a).cross(c - a)).length / 2


def plan_area_of(a, b, c):
    return abs((b - a).cross(c - a).z) / 2


class Parts:
    """Disjoint sets over anything that can be a key."""

    def __init__(self):
        self.parent = {}

    def find(self, key):
        parent = self.parent.setdefault(key, key)
        if parent != key:
            parent = self.parent[key] = self.find(parent)
        return parent

    def unite(self, a, b):
        self.parent[self.find(a)] = self.find(b)


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def meshes():
    return {o.name: o for o in bpy.data.objects if o.type == "MESH"}


def corners(item, polygon):
    return [item.matrix_world @ item.data.vertices[v].co for v in polygon.vertices]


def fan(points, measure):
    return sum(measure(points[0], points[i], points[i + 1]) for i in range(1, len(points) - 1))


def import_obj(path, split):
    clear()
    bpy.ops.import_scene.obj(filepath=path, split_mode="ON" if split else "OFF", use_split_groups=split)


def summed(parts, areas):
    """Of (key of a part, area, area in the plan)."""
    sums = collections.defaultdict(lambda: [0.0, 0.0])
    for key, area, plan in areas:
        sums[parts.find(key)][0] += area
        sums[parts.find(key)][1] += plan
    return sorted(sums.values(), reverse=True)


def read_obj(path):
    import_obj(path, True)
    layers = {}
    for name, item in meshes().items():
        group = name.split(".")[0]
        if group.startswith("layer_") or group == "walkable":
            layers[group] = [sum(fan(corners(item, p), area_of) for p in item.data.polygons), len(item.data.polygons)]
    import_obj(path, False)
    (item,) = meshes().values()
    parts, areas = Parts(), []
    walkable = sum(count for _, count in layers.values())  # these come first; faces of steps and gaps follow
    for polygon in item.data.polygons:
        for v in polygon.vertices[1:]:
            parts.unite(polygon.vertices[0], v)
    # A vertex alone is no way from part to part, but the reader of the indices sees it as one: no such vertex is shared.
    for polygon in item.data.polygons[:walkable]:
        points = corners(item, polygon)
        areas.append((polygon.vertices[0], fan(points, area_of), fan(points, plan_area_of)))
    return {"layers": {name: area for name, (area, _) in layers.items()}, "parts": summed(parts, areas)}


def read_gltf(path):
    clear()
    bpy.ops.import_scene.gltf(filepath=path, merge_vertices=False)
    layers, parts, areas = {}, Parts(), []
    edges = collections.defaultdict(list)  # by the places of their ends: the parts that have them
    for name, item in meshes().items():
        if not (name.startswith("layer_") or name.startswith("walkable")):
            continue
        layers[name] = 0
        for polygon in item.data.polygons:
            for v in polygon.vertices:
                parts.unite((name, polygon.vertices[0]), (name, v))
            points = corners(item, polygon)
            areas.append(((name, polygon.vertices[0]), fan(points, area_of), fan(points, plan_area_of)))
            layers[name] += areas[-1][1]
            for a, b in polygon.edge_keys:
                ends = sorted(tuple(item.data.vertices[v].co) for v in (a, b))
                edges[tuple(ends)].append((name, polygon.vertices[0]))
    for name, item in meshes().items():
        if name in ("steps", "gaps"):
            touched = Parts()
            for polygon in item.data.polygons:
                for v in polygon.vertices:
                    touched.unite(polygon.vertices[0], v)
            first = {}
            for polygon in item.data.polygons:
                for a, b in polygon.edge_keys:
                    ends = tuple(sorted(tuple(item.data.vertices[v].co) for v in (a, b)))
                    for key in edges.get(ends, []):
                        group = touched.find(polygon.vertices[0])
                        parts.unite(first.setdefault(group, key), key)
        elif name == "connections":
            for line in item.data.edges:
                ends = tuple(sorted(tuple(item.data.vertices[v].co) for v in line.vertices))
                for key in edges.get(ends, []):
                    parts.unite(edges[ends][0], key)
    return {"layers": layers, "parts": summed(parts, areas)}


files = sys.argv[sys.argv.index("--") + 1:]
print("read back: " + json.dumps([(read_obj if f.endswith(".obj") else read_gltf)(f) for f in files]))
