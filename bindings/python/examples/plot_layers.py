#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots the walkable area of an environment from above, a picture for each layer. Needs matplotlib.

    plot_layers.py ENVIRONMENT [-o PICTURE.png] [--slope DEGREES] [--height METRES]
"""

import argparse
import math

import footfall
import matplotlib.pyplot as plt
import numpy as np


def main():
    parser = argparse.ArgumentParser(description="Plot the layers of a walkable area from above.")
    parser.add_argument("environment", help="a file that footfall.load() reads")
    parser.add_argument("-o", "--output", help="a picture to write; without it, a window opens")
    parser.add_argument("--slope", type=float, default=45, help="degrees (45)")
    parser.add_argument("--height", type=float, default=2, help="metres (2)")
    arguments = parser.parse_args()

    level = footfall.load(arguments.environment)
    area = footfall.run(level, level.pipeline_for(arguments.slope, arguments.height))
    if len(area.triangles) == 0:
        parser.exit(1, "nothing is walkable\n")

    columns = min(area.layer_count, 3)
    rows = math.ceil(area.layer_count / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(5 * columns, 4.5 * rows), squeeze=False, sharex=True,
                                sharey=True, layout="constrained")
    x, y, z = area.vertices.T
    lowest, highest = z.min(), max(z.max(), z.min() + 1)
    for layer, axis in enumerate(axes.flat):
        if layer >= area.layer_count:
            axis.set_visible(False)
            continue
        triangles = area.triangles[area.layers == layer]
        heights = z[triangles].mean(axis=1)
        picture = axis.tripcolor(x, y, triangles, facecolors=heights, vmin=lowest, vmax=highest, cmap="viridis")
        # The edges that cannot be crossed, where both ends are on this layer.
        walls = area.obstacle_edges[np.isin(area.obstacle_edges, triangles).all(axis=1)]
        axis.plot(x[walls.T], y[walls.T], color="crimson", linewidth=1.5)
        axis.set_title(f"layer {layer}: {len(triangles)} triangles")
        axis.set_aspect("equal")
    figure.colorbar(picture, ax=axes, label="height")
    figure.suptitle(f"{arguments.environment}: {area.area:.1f} square units in {area.layer_count} layers")
    if arguments.output:
        figure.savefig(arguments.output, dpi=120)
    else:
        plt.show()


if __name__ == "__main__":
    main()
