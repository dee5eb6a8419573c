#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots the walkable area of an environment from above, a picture for each layer. Needs matplotlib.

    plot_layers.py ENVIRONMENT [-o PICTURE.png] [--slope DEGREES] [--height METRES]
"""

import argparse

import footfall


def main():
    parser = argparse.ArgumentParser(description="Plot the layers of a walkable area from above.")
    parser.add_argument("environment", help="a file that footfall.load() reads")
    parser.add_argument("-o", "--output", help="a picture to write; without it, a window opens")
    parser.add_argument("--slope", type=float, default=45, help="degrees (45)")
    parser.add_argument("--height", type=float, default=2, help="metres (2)")
    arguments = parser.parse_args()

    area = footfall.run(footfall.load(arguments.environment), footfall.Agent(arguments.slope, arguments.height))
    if len(area.triangles) == 0:
        parser.exit(1, "nothing is walkable\n")
    figure = footfall.plot(area)
    figure.suptitle(f"{arguments.environment}: {area.area:.1f} square units in {area.layer_count} layers")
    if arguments.output:
        figure.savefig(arguments.output, dpi=120)
    else:
        from matplotlib import pyplot

        pyplot.show()


if __name__ == "__main__":
    main()
