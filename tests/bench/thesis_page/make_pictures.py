"""make_pictures.py FOOTFALL SAMPLES FOLDER: the thesis's figures 25 to 37 for our samples, each with its caption.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import pathlib
import subprocess
import sys

from plan_picture import draw

# Number of the figure, sample, strategy, what the thesis shows there.
PARTITIONS = [
    ("25", "house", "GridStrategy 3 3", "grid, 3 x 3"),
    ("26", "house", "SortedRecursiveStrategy 50 3 true", "sorted recursive"),
    ("27a", "house", "RecursiveStrategy 50 2 true", "recursive, depth 2"),
    ("27b", "house", "RecursiveStrategy 50 3 true", "recursive, depth 3"),
    ("28", "villa", "GridStrategy 3 3", "grid, 3 x 3"),
    ("29a", "villa", "GridStrategy 2 2", "grid, 2 x 2"),
    ("29b", "villa", "SortedRecursiveStrategy 50 2 true", "sorted recursive, 4 cells"),
    ("30", "villa", "RecursiveStrategy 50 3 true", "recursive"),
    ("31", "arena", "RecursiveStrategy 50 3 true", "recursive, depth 3"),
    ("32", "arena", "SortedRecursiveStrategy 50 3 true", "sorted recursive, depth 3"),
    ("33", "tower", "GridStrategy 2 2", "grid, 2 x 2"),
    ("34a", "docks", "SortedRecursiveStrategy 50 4 true", "sorted recursive, depth 4 (the thesis shows no cells)"),
]


def run(command):
    """Standard output of a program; its own message where it fails."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: {done.stderr.strip()}")
    return done.stdout


def save(folder, name, data, caption):
    """A picture and the text below it."""
    (folder / name).write_bytes(data)
    (folder / name).with_suffix(".txt").write_text(caption, encoding="utf-8")


def partitions(footfall, samples, folder):
    """Figures 25 to 34: what the strategies cut."""
    cut = folder / "cut.obj"
    for figure, sample, strategy, what in PARTITIONS:
        environment = str(samples / sample / f"{sample}.obj")
        report = json.loads(run([footfall, "cells", environment, "--strategy", strategy, "--json", "-o", str(cut)]))
        y_up = report["environment"]["up"].lower() == "y"
        caption = (
            f"Figure {figure}: {sample}, {what}: {len(report['cells'])} cells, "
            f"{report['environment']['triangles']:,} triangles, cut {report['cut']['triangles']:,}"
        )
        save(folder, f"partition-{figure}-{sample}.png", draw(cut, y_up), caption)
    cut.unlink()


def clearance(footfall, samples, folder):
    """Figure 34: the ground of the docks behind the vertical clearance filter."""
    result, environment = folder / "docks.obj", samples / "docks" / "docks.obj"
    run([footfall, "run", str(environment), "--quiet", "--filter", "DegeneracyFilter", "--filter", "SlopeFilter 45 0",
         "--filter", "VerticalClearanceFilter 2", "-o", str(result)])
    y_up = json.loads(run([footfall, "cells", str(environment), "--json"]))["environment"]["up"].lower() == "y"
    save(folder, "partition-34b-docks.png", draw(result, y_up, True),
         "Figure 34: docks behind the vertical clearance filter, with the edges of its triangles")
    result.unlink()


def distances(footfall, samples, folder):
    """Figures 35 to 37: from the sequential result to that of the parallel listing, which rounds."""
    for sample in ("house", "villa", "arena"):
        lines = [
            line for line in (samples / sample / f"{sample}.pipeline").read_text(encoding="utf-8").splitlines()
            if line and not line.startswith("#")
        ]
        value = {line.split()[0]: line.split()[1] for line in lines if len(line.split()) > 1}
        first = ["DegeneracyFilter", f"SlopeFilter {value['SlopeFilter']} 0", "DuplicationFilter 0.005"]
        clearance_filter = f"VerticalClearanceFilter {value['VerticalClearanceFilter']}"
        last = ["DegeneracyFilter", "DuplicationFilter 0.005", f"AreaFilter {value['AreaFilter']}"]
        pipelines = {
            "sequential": first + [clearance_filter] + last + ["SimplificationFilter", "LayerSubdivisionFilter"],
            "parallel": first
            + ["SortedRecursiveStrategy 50 4 true", "DegeneracyFilter", clearance_filter, "RoundingFilter true", "Collapse"]
            + last
            + ["SimplificationFilter true 0.000001", "LayerSubdivisionFilter"],
        }
        results = {}
        for name, steps in pipelines.items():
            file, results[name] = folder / f"{name}.pipeline", folder / f"{sample}-{name}.obj"
            file.write_text("\n".join(steps) + "\n", encoding="utf-8")
            run([footfall, "run", str(samples / sample / f"{sample}.obj"), "--quiet", "-p", str(file), "-o",
                 str(results[name])])
            file.unlink()
        picture = folder / f"distance-{sample}.svg"
        run([footfall, "compare", str(results["sequential"]), str(results["parallel"]), "--quiet", "--picture", str(picture)])
        picture.with_suffix(".txt").write_text(
            f"{sample}: distance from the sequential listing's result to the parallel one's (figures 35 to 37)",
            encoding="utf-8",
        )
        for path in results.values():
            path.unlink()


def main():
    """Makes all pictures."""
    if len(sys.argv) != 4:
        sys.exit("usage: make_pictures.py FOOTFALL SAMPLES FOLDER")
    footfall, samples, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    partitions(footfall, samples, folder)
    clearance(footfall, samples, folder)
    distances(footfall, samples, folder)


if __name__ == "__main__":
    main()
