# SPDX-License-Identifier: GPL-3.0-or-later
# What other Python programs take: pictures by matplotlib, meshes for trimesh. Nothing here is imported before it is used.
import html
import math
import operator

import numpy as np

from . import _arguments
from ._core import Comparison, Environment, InputError, NavigationMesh, Pipeline, WalkableArea

_STEP, _GAP, _DROP, _WALL, _CONNECTION = "#c8a000", "#e07000", "#8030b0", "crimson", "black"


def _layers_of(mesh, layers):
    """Numbers of layers, or [None] for a mesh without them."""
    if mesh.layers is None:
        if layers is not None:
            raise InputError("layers: this mesh has none; leave them out, or end the pipeline with a layer filter")
        return [None]
    if layers is None:
        return list(range(mesh.layer_count))
    try:
        chosen = [operator.index(layer) for layer in np.atleast_1d(layers)]
    except TypeError:
        raise TypeError(f"layers: {layers!r} is not accepted; give whole numbers or None") from None
    for layer in chosen:
        if not 0 <= layer < mesh.layer_count:
            raise InputError(f"layers: there is no layer {layer}; give numbers from 0 to {mesh.layer_count - 1}")
    return chosen


def _triangles_of(mesh, layer):
    triangles = np.asarray(mesh.triangles)
    return triangles if layer is None else triangles[np.asarray(mesh.layers) == layer]


def trimesh_dict(mesh, layer=None):
    """Return a mesh as a dict that `trimesh.Trimesh(**d)` takes, without changing anything: "vertices" of shape (n, 3),
    float64, "faces" of shape (m, 3), int64, and "process", False.

    layer: the number of one layer, whose vertices are then the only ones; None: the whole mesh, with the rows of
    `mesh.vertices`.

    Raises InputError for a layer that there is not."""
    (number,) = _layers_of(mesh, layer) if layer is not None else (None,)
    faces = _triangles_of(mesh, number).astype(np.int64)
    vertices = np.array(mesh.vertices)
    if number is not None:
        used, faces = np.unique(faces, return_inverse=True)
        vertices, faces = vertices[used], faces.reshape(-1, 3)
    return {"vertices": vertices, "faces": faces, "process": False}


class Components(list):
    """The connected parts of a walkable area, a list of `Component`, the largest first."""

    def __init__(self, components=(), of_triangle=None):
        """Make the list of `components`; of_triangle: shape (m,), the number of the component of each triangle."""
        super().__init__(components)
        self._of_triangle = np.zeros(0, np.uint32) if of_triangle is None else of_triangle

    @property
    def of_triangle(self):
        """Shape (m,), uint32: of each triangle of the mesh the component that it is in, a place in this list."""
        return self._of_triangle

    @property
    def total_area(self):
        """Of all of them."""
        return math.fsum(component.area for component in self)


def _to_trimesh(self, layer=None):
    """Return the mesh as a `trimesh.Trimesh`, whose vertices and faces are in the order of this one.

    layer: the number of one layer; None: the whole mesh.

    Raises InputError for a layer that there is not, and ImportError without trimesh."""
    try:
        import trimesh
    except ImportError as error:
        raise ImportError("NavigationMesh.to_trimesh() needs trimesh; install it (pip install trimesh)") from error
    return trimesh.Trimesh(**trimesh_dict(self, layer))


def _polygons(self, part=None):
    """Return the area seen from above as a list of `shapely.geometry.Polygon`, in the units of the environment: by layer,
    then by their first triangles.

    part: the number of a connected part, as `components` numbers them, for its polygons alone; None: all.

    Triangles of one part and one layer that share an edge seen from above are one polygon, so that thin walls inside are
    not seen: `obstacle_edges` has them. `layer` gives a mesh of one layer. Raises InputError for a part that there is
    not, and ImportError without shapely."""
    if part is not None:
        try:
            part = operator.index(part)
        except TypeError:
            raise TypeError(f"NavigationMesh.polygons(): part: {_arguments.with_article(type(part).__name__)} is not "
                            "accepted; give a whole number or None") from None
        count = len(self.components())
        if not 0 <= part < count:
            raise InputError(f"part: there is no connected part {part}; " +
                             (f"give a number from 0 to {count - 1}" if count else "nothing is walkable"))
    try:
        from shapely.geometry import Polygon
    except ImportError as error:
        raise ImportError("NavigationMesh.polygons() needs shapely; install it (python3-shapely)") from error
    return [Polygon(outer[:, :2], [hole[:, :2] for hole in holes])
            for _layer, _part, outer, holes, _area in self._polygons(part)]


def _table(title, rows):
    """A table of HTML for notebooks."""
    cells = "".join(f"<tr><th style='text-align:left'>{html.escape(str(name))}</th><td>{html.escape(str(value))}</td></tr>"
                    for name, value in rows)
    return f"<table><caption>{html.escape(title)}</caption>{cells}</table>"


def _shown_name(name):
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


def _environment_html(self):
    """A table for notebooks."""
    return _table("Environment " + _shown_name(self.source), [
        ("vertices", len(self.vertices)), ("triangles", len(self.triangles)), ("parts", len(self.parts)),
        ("up axis of the file", self.up + (" (guessed)" if self.up_is_guessed else "")),
        ("metres for a unit", f"{self.metres_per_unit:g}" + (" (guessed)" if self.scale_is_guessed else ""))])


def _mesh_rows(mesh):
    parts = mesh.components()
    rows = [("triangles", len(mesh.triangles)), ("layers", mesh.layer_count), ("connected parts", len(parts)),
            ("steps and gaps", len(mesh.links)), ("drops", len(mesh.drops))]
    return [("area", f"{parts.total_area:.6g}")] + rows


def _mesh_html(self):
    """A table for notebooks."""
    return _table("NavigationMesh", _mesh_rows(self))


def _area_html(self):
    """A table for notebooks."""
    steps = [(f"step {i}", " ".join(str(value) for value in step)) for i, step in enumerate(self.pipeline)]
    return _table("WalkableArea of " + _shown_name(self.environment.source), _mesh_rows(self) + steps)


def _pipeline_html(self):
    """A table for notebooks."""
    return _table("Pipeline", [(step[0], " ".join(str(value) for value in step[1:])) for step in self])


def _comparison_html(self):
    """A table for notebooks."""
    return _table(repr(self)[1:-1], [
        ("equal, exactly", self.equal), ("exact area in A only", self.exact_only_a),
        ("exact area in B only", self.exact_only_b), ("exact area in both", self.exact_both),
        (f"area of A not covered by B, heights within {self.height:g}", self.uncovered_a),
        (f"area of B not covered by A, heights within {self.height:g}", self.uncovered_b)])


def add_methods():
    """Put the methods that are written in Python onto the classes of the module."""
    for name, function in (("to_trimesh", _to_trimesh), ("polygons", _polygons)):
        function.__name__ = name
        function.__qualname__ = "NavigationMesh." + name
        setattr(NavigationMesh, name, function)
    for kind, function in ((Environment, _environment_html), (NavigationMesh, _mesh_html), (WalkableArea, _area_html),
                           (Pipeline, _pipeline_html), (Comparison, _comparison_html)):
        kind._repr_html_ = function


def _bounds_from(bounds):
    """(x0, y0, x1, y1) as floats."""
    try:
        numbers = [float(number) for number in bounds]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != 4 or not np.isfinite(numbers).all() or numbers[0] >= numbers[2] or numbers[1] >= numbers[3]:
        raise InputError(f"bounds: {bounds!r} is no rectangle; give (x0, y0, x1, y1) with x0 < x1 and y0 < y1, or None")
    return numbers


def _within(vertices, triangles, bounds):
    """Those of the triangles whose boxes meet a rectangle."""
    if bounds is None or len(triangles) == 0:
        return triangles
    corners = vertices[triangles][:, :, :2]
    low, high = corners.min(axis=1), corners.max(axis=1)
    return triangles[(low <= bounds[2:]).all(axis=1) & (high >= bounds[:2]).all(axis=1)]


def plot(mesh, layers=None, *, path=None, columns=3, bounds=None):
    """Draw a walkable area from above, a picture for each layer, coloured by height, and return the matplotlib figure.

    mesh: a `WalkableArea` or `NavigationMesh`.
    layers: numbers of the layers to draw, or one; None: all.
    path: a `Path`, drawn where it runs on a layer; None: no path.
    columns: how many pictures stand side by side, at most.
    bounds: the rectangle (x0, y0, x1, y1) to show, as coordinates of the mesh; colours are those of the heights in it.
        None: everything.

    Red lines cannot be crossed; black dashes are where two layers meet; steps are yellow, gaps orange, drops violet.
    A figure can be saved with figure.savefig("plan.png").

    Raises InputError for a layer that there is not and for bounds that are no rectangle, and ImportError without
    matplotlib."""
    numbers = _layers_of(mesh, layers)
    bounds = None if bounds is None else np.array(_bounds_from(bounds))
    if not hasattr(type(columns), "__index__"):
        raise TypeError(f"columns: {columns!r} is not accepted; give a whole number")
    if columns < 1:
        raise InputError(f"columns: {columns} is out of range; give 1 or more")
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("footfall.plot() needs matplotlib; install it (python3-matplotlib)") from error
    columns = max(1, min(columns, len(numbers)))
    rows = max(1, math.ceil(len(numbers) / columns))
    figure, axes = pyplot.subplots(rows, columns, figsize=(5 * columns, 4.5 * rows), squeeze=False, sharex=True,
                                   sharey=True, layout="constrained")
    vertices = np.asarray(mesh.vertices)
    shown = _within(vertices, np.asarray(mesh.triangles), bounds)
    heights = vertices[shown, 2].mean(axis=1) if len(shown) else np.zeros(1)
    shades = dict(vmin=heights.min(), vmax=max(heights.max(), heights.min() + 1e-9), cmap="viridis")
    picture = None
    for axis in axes.flat[len(numbers):]:
        axis.set_visible(False)
    for axis, layer in zip(axes.flat, numbers):
        triangles = _within(vertices, _triangles_of(mesh, layer), bounds)
        if len(triangles):
            picture = axis.tripcolor(vertices[:, 0], vertices[:, 1], triangles,
                                     facecolors=vertices[triangles, 2].mean(axis=1), **shades)
        _draw_lines(axis, mesh, vertices, triangles)
        if path is not None:
            _draw_path(axis, mesh, path, layer)
        axis.set_aspect("equal")
        if bounds is not None:
            axis.set_xlim(bounds[0], bounds[2])
            axis.set_ylim(bounds[1], bounds[3])
        axis.set_title("walkable" if layer is None else f"layer {layer}")
    if picture is not None:
        figure.colorbar(picture, ax=axes, label="height")
    return figure


def _draw_lines(axis, mesh, vertices, triangles):
    on_layer = np.zeros(len(vertices), bool)
    on_layer[triangles.ravel()] = True

    def draw(edges, **style):
        edges = np.asarray(edges)
        edges = edges[on_layer[edges].all(axis=1)]
        axis.plot(vertices[edges.T, 0], vertices[edges.T, 1], **style)

    draw(mesh.obstacle_edges, color=_WALL, linewidth=1.5)
    draw(mesh.connections, color=_CONNECTION, linewidth=1, linestyle="--")
    links, is_gap = np.asarray(mesh.links), np.asarray(mesh.link_is_gap)
    for chosen, colour in ((~is_gap, _STEP), (is_gap, _GAP)):
        for ends in (links[chosen][:, :2], links[chosen][:, 2:]):
            draw(ends, color=colour, linewidth=1.2)
    places, drops = np.asarray(mesh.drop_places), np.asarray(mesh.drops)
    for start, landing in zip(places[:, :2], places[:, 2:]) if len(drops) else ():
        a, b = start.mean(axis=0), landing.mean(axis=0)
        axis.plot([a[0], b[0]], [a[1], b[1]], color=_DROP, linewidth=1)


def _draw_path(axis, mesh, path, layer):
    points = np.asarray(path.points)
    for i, triangle in enumerate(np.asarray(path.triangles)):
        if layer is None or mesh.layers[triangle] == layer:
            for colour, width in (("black", 4), ("white", 2)):
                axis.plot(points[i:i + 2, 0], points[i:i + 2, 1], color=colour, linewidth=width,
                          solid_capstyle="round", zorder=3)
