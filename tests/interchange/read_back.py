# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes every format of an environment and has programs that are not ours read it back: read_back.py FOOTFALL ENV...

The connected parts and areas that they find must be those that `footfall run --stats` states. A program that is not
installed is left out, and said; exits with 77 where none is, with 1 where something differs.
"""

import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).resolve().parent
FLOATS = 2e-4  # of an area: formats with floats, and readers that compute with them
problems, left_out, checked = [], set(), collections.Counter()


def run(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True, **options)


def answer(output):
    return json.loads(re.search(r"^read back: (.*)$", output, re.MULTILINE).group(1))


def same(reader, what, found, stated, tolerance=FLOATS):
    found, stated = list(found), list(stated)
    checked[reader] += 1
    if len(found) != len(stated) or any(abs(a - b) > tolerance * max(abs(b), 1) for a, b in zip(found, stated)):
        problems.append(f"{reader}: {what}: {found[:8]} ({len(found)}) read, {stated[:8]} ({len(stated)}) stated")


def has(program):
    if shutil.which(program):
        return True
    left_out.add(program)
    return False


class Level:
    def __init__(self, footfall, environment, folder):
        self.footfall, self.environment, self.folder = footfall, environment, folder
        statistics = folder / "statistics.json"
        run(footfall, "run", environment, "--quiet", "--stats", statistics)
        stated = json.loads(statistics.read_text())
        self.scale = stated["environment"]["metres_per_unit"]
        self.layers = [layer["area"] * self.scale**2 for layer in stated["layer_list"]]
        self.parts = [part["area"] * self.scale**2 for part in stated["components"]]

    def write(self, name, *options, command="run"):
        target = self.folder / name
        run(self.footfall, command, self.environment, "--quiet", "-o", target, *options)
        return target


def check_blender(level):
    if not has("blender"):
        return
    files = [level.write("level.obj"), level.write("level.glb"), level.write("level.gltf")]
    output = run("blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "blender_reader.py",
                 "--", *files).stdout
    for file, found in zip(files, answer(output)):
        reader = f"Blender, {file.suffix}"
        unit = level.scale if file.suffix == ".obj" else 1
        names = sorted(found["layers"], key=lambda name: int(name.split("_")[1]) if "_" in name else 0)
        same(reader, "areas of layers", [found["layers"][name] * unit**2 for name in names], level.layers)
        areas = [area * unit**2 for area, _ in found["parts"]]
        same(reader, "areas of parts", areas[:len(level.parts)], level.parts)
        same(reader, "number of parts", [len(areas)], [len(level.parts)], 0)
        if file.suffix == ".obj":
            level.plan_areas = [plan * unit**2 for _, plan in found["parts"]]


def check_shapely(level):
    try:
        import shapely
        import shapely.geometry
        import shapely.wkt
    except ImportError:
        left_out.add("python3-shapely")
        return
    features = json.loads(level.write("level.geojson").read_text())["features"]
    areas, plans, layers = collections.Counter(), collections.Counter(), collections.Counter()
    for feature in features:
        properties, shape = feature["properties"], shapely.geometry.shape(feature["geometry"])
        if properties["kind"] != "walkable":
            continue
        if not shape.is_valid:
            problems.append(f"Shapely, .geojson: a polygon of part {properties['part']} is not valid")
        areas[properties["part"]] += properties["area"]
        plans[properties["part"]] += shape.area
        layers[properties["layer"]] += shape.area
    same("Shapely, .geojson", "areas of parts", [areas[i + 1] for i in range(len(areas))], level.parts, 1e-9)
    if hasattr(level, "plan_areas"):
        same("Shapely, .geojson", "plan areas of parts", sorted(plans.values(), reverse=True),
             sorted(level.plan_areas, reverse=True))
    target = level.write("level.wkt")
    found = []
    for layer in range(len(layers)):
        file = target if len(layers) == 1 else target.with_name(f"level-{layer}.wkt")
        shape = shapely.wkt.loads(file.read_text())
        if not shape.is_valid:
            problems.append(f"Shapely, {file.name}: not valid")
        found.append(shape.area)
    same("Shapely, .wkt", "plan areas of layers", found, [layers[i] for i in range(len(layers))], 1e-9)
    for part in range(min(3, len(level.parts))):
        files = level.write("part.wkt", "--part", part + 1).parent.glob("part*.wkt")
        total = sum(shapely.wkt.loads(f.read_text()).area for f in files if not f.name.endswith("-links.wkt"))
        same("Shapely, .wkt --part", f"plan area of part {part + 1}", [total], [plans[part + 1]], 1e-9)


def check_godot(level):
    if not has("godot3-server"):
        return
    folder = level.folder / "godot"
    folder.mkdir(exist_ok=True)
    shutil.move(level.write("level.tres", "--godot", "3"), folder / "level.tres")
    (folder / "project.godot").write_text("config_version=4\n")
    shutil.copy(HERE / "godot_reader.gd", folder / "read.gd")
    found = answer(run("godot3-server", "--path", folder, "-s", "read.gd").stdout)
    places = [tuple(float(x) for x in v.split()) for v in found["vertices"]]
    parent = list(range(len(found["polygons"])))

    def find(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    # As Godot joins them: by the places of both ends.
    edges = {}
    for number, polygon in enumerate(found["polygons"]):
        for a, b in zip(polygon, polygon[1:] + polygon[:1]):
            key = tuple(sorted((places[int(a)], places[int(b)])))
            parent[find(edges.setdefault(key, number))] = find(number)
    areas = collections.Counter()
    for number, polygon in enumerate(found["polygons"]):
        points = [places[int(v)] for v in polygon]
        areas[find(number)] += abs(sum(p[0] * q[2] - p[2] * q[0] for p, q in zip(points, points[1:] + points[:1]))) / 2
    areas = sorted((area for area in areas.values() if area > 1e-4), reverse=True)
    same("Godot 3, .tres", "number of parts", [len(areas)], [len(level.parts)], 0)
    if hasattr(level, "plan_areas"):  # bridges over gaps are polygons here
        same("Godot 3, .tres", "plan areas of parts", areas, sorted(level.plan_areas, reverse=True), 2e-3)


def check_plans(level):
    pages = max(1, len(level.layers))
    if has("pdftotext") and has("pdfinfo"):
        plan = level.write("plan.pdf", command="plan")
        info = run("pdfinfo", plan).stdout
        same("Poppler, .pdf", "pages", [int(re.search(r"Pages:\s+(\d+)", info).group(1))], [pages], 0)
        words = run("pdftotext", "-layout", plan, "-").stdout
        totals = [float(a) for a in re.findall(r"walkable ([\d.]+) m", words)]
        # Floors inside walls are not counted on plans, so that the sum may be less.
        if not 0.5 * sum(level.layers) < sum(totals) <= 1.001 * sum(level.layers) + 0.1 * pages:
            problems.append(f"Poppler, .pdf: {sum(totals)} m2 read, {sum(level.layers)} stated")
        checked["Poppler, .pdf"] += 1
    if has("rsvg-convert"):
        level.write("plan.svg", command="plan")
        files = sorted(level.folder.glob("plan*.svg"))
        same("librsvg, .svg", "pages", [len(files)], [pages], 0)
        for file in files:
            xml.etree.ElementTree.parse(file)
            picture = subprocess.run(["rsvg-convert", "--dpi-x", "50", "--dpi-y", "50", file], check=True,
                                     capture_output=True).stdout
            if not picture.startswith(b"\x89PNG"):
                problems.append(f"librsvg, {file.name}: no picture")


def main():
    footfall, environments = pathlib.Path(sys.argv[1]), [pathlib.Path(e) for e in sys.argv[2:]]
    for environment in environments:
        before = len(problems)
        with tempfile.TemporaryDirectory() as folder:
            level = Level(footfall, environment, pathlib.Path(folder))
            for check in (check_blender, check_shapely, check_godot, check_plans):
                check(level)
        for i in range(before, len(problems)):
            problems[i] = f"{environment.name}: {problems[i]}"
    for program in sorted(left_out):
        print(f"left out: {program} is not installed")
    for reader, count in checked.items():
        print(f"{reader}: {count} comparisons")
    print("\n".join(problems))
    if not checked:
        print("skipped: no program that could read anything is installed")
        return 77
    return 1 if problems else 0


sys.exit(main())
