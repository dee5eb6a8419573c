# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact walkable area of 3D environments.

From arrays:

    import footfall
    area = footfall.walkable_area(vertices, triangles, slope=45, height=2)
    area.vertices, area.triangles, area.layers, area.area

From files, with filters of your own:

    level = footfall.load("level.glb")
    area = footfall.run(level, footfall.Agent(slope=30, height=1.8, radius=0.3))
    area = footfall.run(level, [("SlopeFilter", 40), ("VerticalClearanceFilter", 1.8), ("AreaFilter", 2)])
    area.save("walkable.obj")
    print(area.why((3, 4, 0)))                       # why is this place walkable, or why not?
    print(area.find_path((3, 4, 0), (10, 2, 3)))     # the shortest path, or what keeps both places apart
    area.components()[0].area                        # the largest part that hangs together
    area.random_places(100)                          # evenly by area
    footfall.plot(area).savefig("plan.png")          # a picture of each layer, by matplotlib

Shapes and units. Vertices are float64 arrays of shape (n, 3), triangles integers of shape (m, 3): rows of the vertices,
counter-clockwise seen from the front, which can be walked on. Inside, Z is up, whatever a file has, and coordinates stay
in the file's units; `metres_per_unit` says what these are. Slopes are degrees. Arrays that are given are copied; arrays
that are returned are views without a copy, cannot be written to, and keep alive what they show.

Threads. `run` and all else that takes long gives the interpreter lock away while it works on all cores; environments,
meshes and caches may be shared by threads. Ctrl-C cancels within some 50 ms and raises KeyboardInterrupt. The result does
not depend on the number of threads. Start other processes by "spawn", not by "fork", which leaves the worker threads behind
(multiprocessing.set_start_method).

Errors. `InputError` (a ValueError): a file, an array, a pipeline or a parameter is wrong. `RunError` (a RuntimeError): a
result cannot be written, or memory or disk ran out. Both say in one line what, where and what to do, and so does a TypeError
for an argument that there is not or that has another type.

Pickles. Environments, areas, meshes and pipelines can be pickled; an area keeps its environment, and no cache.
"""

from . import _arguments, _core, _views
from ._core import (
    Agent,
    BodyPath,
    BodyPaths,
    BorderLink,
    Bottleneck,
    ComparedPart,
    Comparison,
    Component,
    Corridor,
    CorridorMap,
    Distances,
    EditableEnvironment,
    Environment,
    Explanation,
    Filter,
    InputError,
    NavigationMesh,
    Parameter,
    Passage,
    Path,
    Pipeline,
    Place,
    Ray,
    ResultCache,
    RunError,
    WalkableArea,
    __version__,
    agents,
    compare,
    filters,
    importable_extensions,
    load,
    read_mesh,
    read_pipeline,
    run,
    walkable_area,
)
from ._views import Components, plot, trimesh_dict

__all__ = [
    "Agent",
    "BodyPath",
    "BodyPaths",
    "BorderLink",
    "Bottleneck",
    "ComparedPart",
    "Comparison",
    "Component",
    "Components",
    "Corridor",
    "CorridorMap",
    "Distances",
    "EditableEnvironment",
    "Environment",
    "Explanation",
    "Filter",
    "InputError",
    "NavigationMesh",
    "Parameter",
    "Passage",
    "Path",
    "Pipeline",
    "Place",
    "Ray",
    "ResultCache",
    "RunError",
    "WalkableArea",
    "agents",
    "compare",
    "filters",
    "importable_extensions",
    "load",
    "plot",
    "read_mesh",
    "read_pipeline",
    "run",
    "trimesh_dict",
    "walkable_area",
]


# Messages, help() and pickle name things as users import them.
for _name in __all__:
    globals()[_name].__module__ = __name__
    if not hasattr(_core, _name):
        continue
    if isinstance(globals()[_name], type):
        _arguments.check_methods(globals()[_name])
    else:
        globals()[_name] = _arguments.checked(globals()[_name], _name)
_views.add_methods()
del _arguments, _core, _name, _views
