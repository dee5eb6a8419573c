"""make_page.py FOLDER PAGE.html: one page of all that thesis.sh has measured into FOLDER. What is missing there is said.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import base64
import html
import json
import pathlib
import re
import sys

from markdown_html import to_html
from svg_plot import line_plot, stacked_bars

PHASES = ["preprocessing_ms", "partitioning_ms", "parallel_ms", "merging_ms", "postprocessing_ms", "overhead_ms"]
PHASE_NAMES = ["t_pre", "t_part", "t_parallel", "t_merge", "t_post", "t_overhead"]
FORMATS = {
    ("ascii", 1): ("ASCII, d = 1", 0), ("ascii", 12): ("ASCII, d = 12", 1), ("binary", 1): ("binary, d = 1", 2),
    ("binary", 12): ("binary, d = 12", 3), ("tree", 1): ("tree, d = 1", 4), ("tree", 3): ("tree, d = 3", 5),
    ("tree", 12): ("tree, d = 12", 6), ("provenance", 0): ("provenance (ours)", 7),
}
STYLE = """
body { font: 15px/1.45 sans-serif; max-width: 1200px; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; font-size: 13px; margin: .8em 0 } td, th { border: 1px solid #ccc; padding: 2px 6px }
td.r { text-align: right } svg { font: 11px sans-serif } svg.plot { width: 560px; max-width: 100% }
svg.wide { width: 100%; max-width: 900px } figure { display: inline-block; margin: .5em; vertical-align: top }
figure img { max-width: 420px } figure.map img { max-width: 900px; width: 100% } figcaption { max-width: 420px; font-size: 13px }
.missing { color: #a33 }
"""


class Page:
    """What was measured, and the page that is made of it."""

    def __init__(self, folder):
        self.folder, self.out = folder, []

    def json(self, name):
        """A file's content, or null with a note in the page."""
        path = self.folder / name
        if path.is_file():
            return json.loads(path.read_text(encoding="utf-8"))
        self.out.append(f'<p class="missing">{html.escape(name)} was not measured.</p>')
        return None

    def markdown(self, name):
        """The text of a file, as HTML."""
        path = self.folder / name
        if path.is_file() and path.stat().st_size > 0:
            self.out.append(to_html(path.read_text(encoding="utf-8")))
        else:
            self.out.append(f'<p class="missing">{html.escape(name)} was not measured.</p>')

    def add(self, text):
        """Adds HTML."""
        self.out.append(text)

    def machine(self):
        """Which machine, and how busy it was."""
        results = self.json("thesis.json")
        if not results:
            return
        m = results["machine"]
        memory = f"{m['memory_bytes'] / 2**30:.0f} GiB" if m["memory_bytes"] else "unknown memory"
        load = f"{m['load']:.1f}" if m["load"] is not None else "unknown"
        self.add(
            f"<p>Measured by Footfall {html.escape(results['program']['version'])} on {html.escape(str(m['processor']))}, "
            f"{m['processors']} processors, {memory}, {html.escape(m['system'])}; load of the last minute at the start: "
            f"{load}. The thesis had an Intel Core i7-5960X at 3 GHz, 16 cores (32 threads), 32 GB, Windows 10 (5.2).</p>"
        )
        if m["load"] is not None and m["load"] > 0.5:
            self.add(
                '<p class="missing">Other work ran on this machine meanwhile: wall-clock times are too long. Ratios within '
                "one table were measured in turns; processor times are given where there are any.</p>"
            )

    def communication(self):
        """5.3: tables 2 and 3 with plots."""
        results = self.json("communication.json")
        if not results:
            return
        for key, title in (("write_ms", "Writing"), ("read_ms", "Reading")):
            for source in ("ours", "thesis"):
                lines = []
                for (name, depth), (label, colour) in FORMATS.items():
                    points = []
                    for e in results["entries"]:
                        if (e["format"], e["depth"]) != (name, depth):
                            continue
                        value = e[key] if source == "ours" else e.get("thesis", {}).get(key)
                        if value is not None and value > 0:
                            points.append((e["points"], value))
                    if points:
                        lines.append((label, points, colour, "line"))
                self.add(line_plot(f"{title}, ms ({source})", "points", "ms", lines, y_log=True))
        for key, title, unit in (("bytes", "Size", "bytes"), ("write_mb_s", "Writing", "MB/s"), ("read_mb_s", "Reading", "MB/s")):
            lines = [
                (label, [(e["points"], e[key]) for e in results["entries"] if (e["format"], e["depth"]) == kind], colour, "line")
                for kind, (label, colour) in FORMATS.items()
            ]
            self.add(line_plot(f"{title}, {unit} (ours)", "points", unit, [l for l in lines if l[1]], y_log=True))
        self.add(f"<p>The most memory that the benchmark held: {results['peak_bytes'] / 1e6:.0f} MB.</p>")

    def phases(self):
        """5.4: shares of the phases, the thesis's beside ours."""
        results = self.json("thesis.json")
        for environment in (results or {}).get("environments", []):
            bars = []
            for entry in environment.get("strategies", []):
                if "cells" not in entry:
                    continue
                bars.append((entry["label"], [entry[phase] for phase in PHASES]))
                thesis = entry.get("thesis")
                if thesis and all(thesis[phase] is not None for phase in PHASES):
                    bars.append(("the thesis", [thesis[phase] for phase in PHASES]))
            if bars:
                self.add(stacked_bars(f"{environment['name']}: shares of the phases", PHASE_NAMES, bars))

    def scaling(self):
        """5.6: figures 38 and 39."""
        results = self.json("thesis.json")
        processors = (results or {}).get("processors", 1)
        for environment in (results or {}).get("environments", []):
            scaling = environment.get("scaling", {})
            if "lines" not in scaling:
                continue
            for key, title in (("speed_up", "speed-up"), ("efficiency", "efficiency")):
                lines = []
                for i, line in enumerate(scaling["lines"]):
                    points = [(p["threads"], p[key]) for p in line["points"] if key in p]
                    if points:
                        lines.append((line["label"], points, i, "line"))
                threads = [t for t in results["threads"] if key == "efficiency" or t <= max(processors, 2)]
                lines.append(("ideal", [(t, t if key == "speed_up" else 1) for t in threads], 6, "dashed"))
                self.add(
                    line_plot(
                        f"{environment['name']}: {title}", "threads", title, lines, x_base=2, limit=processors,
                        limit_text=f"this machine has {processors} processors; here, threads take turns",
                    )
                )

    def pictures(self, pattern, kind=""):
        """All pictures whose names match, with the text beside them."""
        found = sorted(self.folder.glob(pattern))
        if not found:
            self.add(f'<p class="missing">{html.escape(pattern)}: no picture was made.</p>')
        for path in found:
            text = path.with_suffix(".txt")
            caption = text.read_text(encoding="utf-8") if text.is_file() else path.stem
            mime = "image/png" if path.suffix == ".png" else "image/svg+xml"
            data = base64.b64encode(path.read_bytes()).decode("ascii")
            self.add(
                f'<figure class="{kind}"><img alt="{html.escape(caption)}" src="data:{mime};base64,{data}">'
                f"<figcaption>{html.escape(caption)}</figcaption></figure>"
            )

    def sections(self):
        """The page from top to bottom."""
        report = self.folder / "thesis.md"
        parts = re.split(r"(?m)^(?=### )", report.read_text(encoding="utf-8")) if report.is_file() else []

        def part(word):
            for text in parts:
                if text.startswith("### ") and word in text.splitlines()[0]:
                    self.add(to_html(text))

        self.machine()
        self.add("<h2>5.3 Communication: tables 2 and 3, figures 23 and 24</h2>")
        self.communication()
        self.markdown("communication.md")
        self.add("<h2>5.4 Parallel pipeline: phases, table 4</h2>")
        self.phases()
        part("By strategy")
        part("as they are printed")
        part("What is due")
        self.add("<h2>5.4 Partitions: figures 25 to 34</h2>")
        self.pictures("partition-*.png")
        self.add("<h2>5.5 Correctness: tables 5 to 7, figures 35 to 37</h2>")
        part("Correctness")
        self.pictures("distance-*.svg", "map")
        self.add("<h2>5.6 Scaling: figures 38 and 39</h2>")
        self.scaling()
        part("Scaling")
        self.add("<h2>5.7 Distributed pipeline</h2>")
        self.markdown("distributed.md")
        self.add("<h2>5.1.1 Cut obstacles and rounded cuts: the experiment</h2>")
        self.markdown("rounding.md")
        return (
            "<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>Footfall: the thesis's experiments</title>"
            f"<style>{STYLE}</style></head><body><h1>The thesis's experiments, run again</h1>\n"
            + "\n".join(self.out)
            + "\n</body></html>\n"
        )


def main():
    """Writes the page."""
    if len(sys.argv) != 3:
        sys.exit("usage: make_page.py FOLDER PAGE.html")
    page = Page(pathlib.Path(sys.argv[1])).sections()
    pathlib.Path(sys.argv[2]).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
