# A walkable area as a collection of objects: one mesh for each layer, lines and faces for what joins and parts it.
# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
import numpy as np

from .level import RESULT

COLLECTION = "Walkable area"
LIFT = 0.02  # metres: objects stand a little over the floors that their meshes lie in, or they would flicker
# The editor's colours: layers by hue, steps yellow, gaps orange, drops violet, obstacle edges red, connections white.
_LAYERS = [(0.10, 0.55, 0.25), (0.10, 0.40, 0.70), (0.55, 0.45, 0.10), (0.45, 0.20, 0.60), (0.10, 0.55, 0.55),
           (0.60, 0.25, 0.30)]
_OTHERS = {"steps": (0.95, 0.80, 0.10), "gaps": (0.95, 0.50, 0.05), "drops": (0.60, 0.20, 0.80),
           "obstacle_edges": (0.85, 0.05, 0.05), "connections": (0.95, 0.95, 0.95)}


def _material(name, colour):
    name = "footfall " + name
    material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    material.diffuse_color = (*colour, 1.0)
    return material


def _collection(scene):
    collection = bpy.data.collections.get(COLLECTION)
    if collection is None:
        collection = bpy.data.collections.new(COLLECTION)
    if collection.name not in scene.collection.children:
        scene.collection.children.link(collection)
    return collection


def _compact(vertices, indices):
    used, renumbered = np.unique(np.asarray(indices).ravel(), return_inverse=True)
    return vertices[used], renumbered.reshape(np.shape(indices))


def _links(rows):
    """Edges a to b and c to d, where d lies over a: quads a, b, c, d, or triangles where an end is shared."""
    faces = []
    for a, b, c, d in rows.tolist():
        face = [corner for i, corner in enumerate((a, b, c, d)) if corner not in (a, b, c, d)[:i]]
        if len(face) >= 3:
            faces.append(face)
    return faces


def _put(collection, name, vertices, edges, faces, colour, lift):
    """Make or refill one object; its transform and whether it is hidden stay."""
    obj = next((o for o in collection.objects if o.get(RESULT) == name), None)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices.tolist(), edges, faces)
    mesh.materials.append(_material(name, colour))
    mesh.update()
    if obj is None:
        obj = bpy.data.objects.new(name, mesh)
        obj[RESULT] = name
        obj.color = (*colour, 1.0)
        obj.hide_select = True
        obj.location.z = lift
        collection.objects.link(obj)
    else:
        before, obj.data = obj.data, mesh
        if before.users == 0:
            bpy.data.meshes.remove(before)
    return obj


def show(scene, area):
    """Show a walkable area in place of the one before."""
    collection = _collection(scene)
    vertices, triangles = np.asarray(area.vertices), np.asarray(area.triangles)
    names = set()

    def put(name, points, edges, faces, colour):
        _put(collection, name, points, edges, faces, colour, LIFT / area.metres_per_unit)
        names.add(name)

    layers = area.layers
    if len(triangles) > 0:
        if layers is None:
            points, faces = _compact(vertices, triangles)
            put("walkable", points, [], faces.tolist(), _LAYERS[0])
        else:
            for layer in range(area.layer_count):
                points, faces = _compact(vertices, triangles[layers == layer])
                put(f"layer_{layer}", points, [], faces.tolist(), _LAYERS[layer % len(_LAYERS)])
    links = np.asarray(area.links)
    is_gap = np.asarray(area.link_is_gap)
    for name, rows in (("steps", links[~is_gap]), ("gaps", links[is_gap])):
        if len(rows) > 0:
            points, rows = _compact(vertices, rows)
            put(name, points, [], _links(rows), _OTHERS[name])
    for name, edges in (("obstacle_edges", area.obstacle_edges), ("connections", area.connections)):
        if len(edges) > 0:
            points, rows = _compact(vertices, edges)
            put(name, points, rows.tolist(), [], _OTHERS[name])
    places = np.asarray(area.drop_places)
    if len(places) > 0:
        count = len(places)
        rows = np.arange(4 * count).reshape(count, 4)
        put("drops", places.reshape(-1, 3), np.concatenate([rows[:, [0, 2]], rows[:, [1, 3]]]).tolist(), [],
            _OTHERS["drops"])
    for obj in [o for o in collection.objects if o.get(RESULT) not in names and RESULT in o]:
        mesh = obj.data
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(mesh)
