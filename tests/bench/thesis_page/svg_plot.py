"""Line plots and stacked bars as SVG, with nothing but the standard library.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import html
import math

# Okabe and Ito 2008: told apart by people with the common colour deficiencies.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#8a7a00"]


def ticks_of(low, high, logarithmic, base):
    """Places of marks from `low` to `high`."""
    if logarithmic:
        first, last = math.floor(math.log(low, base) + 1e-9), math.ceil(math.log(high, base) - 1e-9)
        return [base**i for i in range(first, last + 1)]
    step = 10 ** math.floor(math.log10(max(high - low, 1e-12)))
    while (high - low) / step < 4:
        step /= 2
    count = math.ceil((high - low) / step - 1e-9)
    return [low + step * i for i in range(count + 1)]


def number(value):
    """A short text of a number, such as 1M or 0.5."""
    if value >= 1e6 and value % 1e6 == 0:
        return f"{value / 1e6:g}M"
    if value >= 1e3 and value % 1e3 == 0:
        return f"{value / 1e3:g}k"
    return f"{value:g}"


class Axis:
    """Turns values into places between two ends on the paper."""

    def __init__(self, values, start, end, logarithmic=False, base=10, low=None):
        low = min(values) if low is None else low
        self.ticks = ticks_of(low, max(max(values), low * 1.0001 + 1e-12), logarithmic, base)
        self.logarithmic, self.start, self.end = logarithmic, start, end

    def place(self, value):
        """Where on the paper a value lies."""
        low, high = self.ticks[0], self.ticks[-1]
        if self.logarithmic:
            value, low, high = (math.log(max(v, 1e-12)) for v in (value, low, high))
        share = (value - low) / (high - low) if high > low else 0
        return self.start + share * (self.end - self.start)


def line_plot(title, x_title, y_title, lines, x_base=10, y_log=False, limit=None, limit_text=""):
    """An SVG with one polyline for each of `lines`: (label, points, colour number, style).

    `style` is "line", "dashed" or "dots". Right of `limit` on the x axis the plot is grey, and says `limit_text`, a line for each part
    that ends in "; ".
    """
    width, height, left, right, top, bottom = 560, 360, 60, 190, 34, 44
    points = [p for _, line, _, _ in lines for p in line]
    if not points:
        return f"<p>{html.escape(title)}: nothing was measured.</p>"
    x_axis = Axis([p[0] for p in points], left, width - right, True, x_base)
    ys = [p[1] for p in points]
    y_axis = Axis(ys, height - bottom, top, y_log, 10, None if y_log else 0)
    out = [
        f'<svg class="plot" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img">',
        f"<title>{html.escape(title)}</title>",
        f'<text x="{left}" y="18" font-weight="bold">{html.escape(title)}</text>',
    ]
    if limit is not None and limit < x_axis.ticks[-1]:
        x = x_axis.place(limit)
        out.append(
            f'<rect x="{x:.1f}" y="{top}" width="{width - right - x:.1f}" height="{height - bottom - top}" '
            'fill="#e4e4e4"/>'
        )
        for i, words in enumerate(limit_text.split("; ")):
            out.append(f'<text x="{x + 4:.1f}" y="{top + 12 + 13 * i}" font-size="10">{html.escape(words)}</text>')
    for tick in x_axis.ticks:
        x = x_axis.place(tick)
        out.append(f'<path d="M{x:.1f} {top}V{height - bottom}" stroke="#d0d0d0"/>')
        out.append(f'<text x="{x:.1f}" y="{height - bottom + 14}" text-anchor="middle">{number(tick)}</text>')
    for tick in y_axis.ticks:
        y = y_axis.place(tick)
        out.append(f'<path d="M{left} {y:.1f}H{width - right}" stroke="#d0d0d0"/>')
        out.append(f'<text x="{left - 5}" y="{y + 4:.1f}" text-anchor="end">{number(round(tick, 9))}</text>')
    for i, (label, line, colour, style) in enumerate(lines):
        ink = COLOURS[colour % len(COLOURS)]
        if style != "dots":
            path = " ".join(f"{x_axis.place(x):.1f},{y_axis.place(y):.1f}" for x, y in line)
            dashes = ' stroke-dasharray="5 4"' if style == "dashed" else ""
            out.append(f'<polyline points="{path}" fill="none" stroke="{ink}" stroke-width="2"{dashes}/>')
        for x, y in line:
            out.append(f'<circle cx="{x_axis.place(x):.1f}" cy="{y_axis.place(y):.1f}" r="3" fill="{ink}"/>')
        y = top + 10 + 15 * i
        dashes = ' stroke-dasharray="5 4"' if style == "dashed" else ""
        out.append(f'<path d="M{width - right + 10} {y - 4}h18" stroke="{ink}" stroke-width="2"{dashes}/>')
        out.append(f'<text x="{width - right + 33}" y="{y}">{html.escape(label)}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 8}" text-anchor="middle">{html.escape(x_title)}</text>')
    out.append(
        f'<text transform="translate(14 {(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">'
        f"{html.escape(y_title)}</text></svg>"
    )
    return "\n".join(out)


def stacked_bars(title, parts, bars):
    """Horizontal bars of shares of their own sums: `bars` is a list of (label, values), one value for each of `parts`."""
    width, row, left, top = 760, 17, 230, 48
    out = [
        f'<svg class="wide" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {top + row * len(bars) + 6}" role="img">',
        f'<title>{html.escape(title)}</title><text x="4" y="16" font-weight="bold">{html.escape(title)}</text>',
    ]
    x = 4
    for i, part in enumerate(parts):
        out.append(f'<rect x="{x}" y="26" width="10" height="10" fill="{COLOURS[i]}"/>')
        out.append(f'<text x="{x + 14}" y="35">{html.escape(part)}</text>')
        x += 26 + 7 * len(part)
    for i, (label, values) in enumerate(bars):
        total, at, y = sum(values), left, top + row * i
        out.append(f'<text x="{left - 6}" y="{y + 12}" text-anchor="end">{html.escape(label)}</text>')
        for k, value in enumerate(values):
            length = (width - left - 10) * value / total if total > 0 else 0
            out.append(f'<rect x="{at:.1f}" y="{y}" width="{length:.1f}" height="{row - 4}" fill="{COLOURS[k]}"/>')
            at += length
    return "\n".join(out) + "</svg>"
