# SPDX-License-Identifier: GPL-3.0-or-later
# What other Python programs take: pictures by matplotlib, meshes for trimesh. Nothing here is imported before it is used.
import math

import numpy as np

from ._core import InputError

_STEP, _GAP, _DROP, _WALL, _CONNECTION = "#c8a000", "#e07000", "#8030b0", "crimson", "black"


def _layers_of(mesh, layers):
    """Numbers of layers, or [None] for a mesh without them."""
    if mesh.layers is None:
        if layers is not None:
            raise InputError("layers: this mesh has none; leave them out, or end the pipeline with a layer filter")
        return [None]
    if layers is None:
        return list(range(mesh.layer_count))
    chosen = [int(layer) for layer in np.atleast_1d(layers)]
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


def plot(mesh, layers=None, *, path=None, columns=3):
    """Draw a walkable area from above, a picture for each layer, coloured by height, and return the matplotlib figure.

    mesh: a `WalkableArea` or `NavigationMesh`.
    layers: numbers of the layers to draw, or one; None: all.
    path: a `Path`, drawn where it runs on a layer; None: no path.
    columns: how many pictures stand side by side, at most.

    Red lines cannot be crossed; black dashes are where two layers meet; steps are yellow, gaps orange, drops violet.
    A figure can be saved with figure.savefig("plan.png").

    Raises InputError for a layer that there is not, and ImportError without matplotlib."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("footfall.plot() needs matplotlib; install it (python3-matplotlib)") from error
    numbers = _layers_of(mesh, layers)
    columns = max(1, min(columns, len(numbers)))
    rows = max(1, math.ceil(len(numbers) / columns))
    figure, axes = pyplot.subplots(rows, columns, figsize=(5 * columns, 4.5 * rows), squeeze=False, sharex=True,
                                   sharey=True, layout="constrained")
    vertices = np.asarray(mesh.vertices)
    heights = vertices[np.asarray(mesh.triangles), 2].mean(axis=1) if len(mesh.triangles) else np.zeros(1)
    shades = dict(vmin=heights.min(), vmax=max(heights.max(), heights.min() + 1e-9), cmap="viridis")
    picture = None
    for axis in axes.flat[len(numbers):]:
        axis.set_visible(False)
    for axis, layer in zip(axes.flat, numbers):
        triangles = _triangles_of(mesh, layer)
        if len(triangles):
            picture = axis.tripcolor(vertices[:, 0], vertices[:, 1], triangles,
                                     facecolors=vertices[triangles, 2].mean(axis=1), **shades)
        _draw_lines(axis, mesh, vertices, triangles)
        if path is not None:
            _draw_path(axis, mesh, path, layer)
        axis.set_aspect("equal")
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
