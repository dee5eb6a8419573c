#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A notebook as a script: who gets where in a building. Needs matplotlib. Run it whole, or cell by cell (# %%) in an editor.

    walkthrough.py ENVIRONMENT [FOLDER]        # pictures go to FOLDER
"""

# %% An environment, and two agents
import pathlib
import sys

import footfall
import numpy as np

environment = sys.argv[1] if len(sys.argv) > 1 else "samples/house/house.obj"
folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")
level = footfall.load(environment)
person = footfall.agents()["Human"]
wheelchair = footfall.agents()["Wheelchair"]
print(level, person, wheelchair, sep="\n")

# %% Where each can go
areas = {"person": footfall.run(level, person), "wheelchair": footfall.run(level, wheelchair)}
for name, area in areas.items():
    parts = area.components()
    print(f"{name}: {area.area:.1f} square units, {len(parts)} parts, the largest {parts[0].area:.1f}")
    figure = footfall.plot(area)
    figure.suptitle(f"where a {name} can go")
    figure.savefig(folder / f"walkthrough-{name}.png", dpi=80)

# %% The shortest path between the two places of the largest part that are farthest apart in the plan
area = areas["person"]
inside = np.asarray(area.triangles)[np.asarray(area.components().of_triangle) == 0]
middles = np.asarray(area.vertices)[inside].mean(axis=1)
start = middles[np.argmin(middles[:, 0] + middles[:, 1])]
end = middles[np.argmax(middles[:, 0] + middles[:, 1])]
path = area.find_path(start, end)
print(f"{path.length:.1f} long over layers {path.layers}, {len(path.bends)} bends")
footfall.plot(area, path.layers, path=path).savefig(folder / "walkthrough-path.png", dpi=80)

# %% The same way in a wheelchair: what is missing least
barrier = areas["wheelchair"].find_path(start, end)
print(barrier.message or "it gets there, too")

# %% The layers as meshes for trimesh: trimesh.Trimesh(**footfall.trimesh_dict(area, 0))
for layer in range(area.layer_count):
    mesh = footfall.trimesh_dict(area, layer)
    print(f"layer {layer}: {len(mesh['vertices'])} vertices, {len(mesh['faces'])} faces")
