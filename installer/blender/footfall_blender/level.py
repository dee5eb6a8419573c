# The objects of a scene as an environment that is edited where they change.
# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
import numpy as np

RESULT = "footfall_result"  # a custom property of what Footfall made


def is_level(obj):
    """Whether an object is one that agents may walk on or that stands in their way."""
    return obj.type in {"MESH", "CURVE", "SURFACE", "FONT", "META"} and RESULT not in obj


def arrays_of(obj, depsgraph):
    """Triangles of an object as it is seen, modifiers and transforms applied, in the world's frame (Z up).

    Returns (vertices, triangles): shape (n, 3), float64, and (m, 3), int32; (None, None) without triangles."""
    evaluated = obj.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        if mesh is None:
            return None, None
        mesh.calc_loop_triangles()
        count = len(mesh.loop_triangles)
        if count == 0:
            return None, None
        places = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", places)
        triangles = np.empty(3 * count, np.int32)
        mesh.loop_triangles.foreach_get("vertices", triangles)
    finally:
        evaluated.to_mesh_clear()
    world = np.array(obj.matrix_world, np.float64)
    vertices = places.reshape(-1, 3).astype(np.float64) @ world[:3, :3].T + world[:3, 3]
    triangles = triangles.reshape(-1, 3)
    if np.linalg.det(world[:3, :3]) < 0:  # mirrored: fronts are backs
        triangles = triangles[:, ::-1]
    return vertices, np.ascontiguousarray(triangles)


def same_arrays(a, b):
    return all(x is y or (x is not None and y is not None and np.array_equal(x, y)) for x, y in zip(a, b))


class Level:
    """Objects by name; what has changed since the last look is replaced, so that only that is computed again."""

    def __init__(self, footfall):
        self._footfall = footfall
        self._editable = None
        self._ground = None  # the object that the environment began with: the one with most triangles
        self._arrays = {}
        self._ids = {}
        self._units = None

    def update(self, objects, depsgraph, metres_per_unit):
        """Take over the objects as they are. Returns whether anything changed; ValueError when nothing has faces."""
        now = {}
        for obj in objects:
            arrays = arrays_of(obj, depsgraph)
            if arrays[0] is None:
                continue
            if not np.isfinite(arrays[0]).all():
                raise ValueError(f"{obj.name}: a coordinate is not finite; mend it, or leave it out of the selection")
            now[obj.name_full] = arrays
        if not now:
            raise ValueError("the selection has no faces; select what agents walk on and what stands in their way")
        is_known = self._editable is not None and self._units == metres_per_unit
        if not is_known or self._ground not in now or not same_arrays(now[self._ground], self._arrays[self._ground]):
            self._begin(now, metres_per_unit)
            return True
        changed = False
        for name in [name for name in self._ids if name not in now]:
            self._editable.remove(self._ids.pop(name))
            del self._arrays[name]
            changed = True
        for name, arrays in now.items():
            if name in self._arrays and same_arrays(arrays, self._arrays[name]):
                continue
            if name in self._ids:
                self._editable.replace(self._ids[name], *arrays)
            else:
                self._ids[name] = self._editable.add(*arrays)
            self._arrays[name] = arrays
            changed = True
        return changed

    @property
    def environment(self):
        return self._editable.environment

    def _begin(self, now, metres_per_unit):
        self._ground = max(now, key=lambda name: len(now[name][1]))
        environment = self._footfall.Environment(
            *now[self._ground], metres_per_unit=metres_per_unit, name=bpy.path.basename(bpy.data.filepath) or "scene")
        self._editable = self._footfall.EditableEnvironment(environment)
        self._units = metres_per_unit
        self._arrays = now
        self._ids = {name: self._editable.add(*arrays) for name, arrays in now.items() if name != self._ground}
