# Printers for gdb: exact points and lines, vertices, meshes and soups. Load with `gdb -x tools/gdb/footfall.py`.
# SPDX-License-Identifier: GPL-3.0-or-later
import gdb
import gdb.printing


def length(vector):
    """Number of elements of a std::vector."""
    start = vector["_M_impl"]["_M_start"]
    return int(vector["_M_impl"]["_M_finish"] - start)


def line_text(kind, a, b):
    """A PlanLine in words."""
    if kind == 0:
        return f"[edge {a}-{b}]"
    if kind == 1:
        return f"[trace of triangle {a} at level {b}]"
    return f"[border {b} of axis {'xy'[a] if a in (0, 1) else a}]"


class Vec3Printer:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        return f"({float(self.value['x']):.17g}, {float(self.value['y']):.17g}, {float(self.value['z']):.17g})"


class PlanLinePrinter:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        return line_text(int(self.value["kind"]), int(self.value["a"]), int(self.value["b"]))


class PlanPointPrinter:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        n = [int(self.value["numbers_"]["_M_elems"][i]) for i in range(6)]
        kind = int(self.value["kind_"])
        if kind == 0:
            return f"source vertex {n[0]}"
        if kind == 1:
            return f"edge {n[0]}-{n[1]} meets the plane of triangle {n[2]} at level {n[3]}"
        face = int(self.value["face_"])
        on_face = f" on face {face}" if face >= 0 else ""
        return f"crossing of {line_text(*n[0:3])} and {line_text(*n[3:6])}{on_face}"


class MeshVertexPrinter:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        v = self.value
        point = PlanPointPrinter(v["point"]).to_string()
        return (f"{point}, about ({float(v['x']):.17g}, {float(v['y']):.17g}, {float(v['z']):.17g}) "
                f"within {float(v['error']):.3g}, in the plane of face {int(v['face'])}")


class MeshTrianglePrinter:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        corners = [int(self.value["corners"]["_M_elems"][i]) for i in range(3)]
        edges = int(self.value["obstacleEdges"])
        obstacles = [f"{corners[k]}-{corners[(k + 1) % 3]}" for k in range(3) if edges >> k & 1]
        text = f"corners {corners[0]}, {corners[1]}, {corners[2]} on face {int(self.value['face'])}"
        return text + (f", obstacles on {', '.join(obstacles)}" if obstacles else "")


class CountsPrinter:
    """A mesh or a soup by the numbers of its elements; `print/r` shows its members."""

    members = ("vertices", "triangles", "layers", "links", "drops", "obstacleEdges", "connections", "parts")

    def __init__(self, value):
        self.value = value

    def find(self, value, name):
        for field in value.type.strip_typedefs().fields():
            if field.name == name:
                return value[field]
            if field.is_base_class:
                found = self.find(value[field], name)
                if found is not None:
                    return found
        return None

    def to_string(self):
        counts = []
        for name in self.members:
            member = self.find(self.value, name)
            if member is not None and length(member) > 0:
                counts.append(f"{length(member)} {name}")
        return ", ".join(counts) if counts else "empty"


def make_printers():
    printers = gdb.printing.RegexpCollectionPrettyPrinter("footfall")
    printers.add_printer("Vec3", "^footfall::Vec3$", Vec3Printer)
    printers.add_printer("PlanLine", "^footfall::detail::PlanLine$", PlanLinePrinter)
    printers.add_printer("PlanPoint", "^footfall::detail::PlanPoint$", PlanPointPrinter)
    printers.add_printer("MeshVertex", "^footfall::detail::MeshVertex$", MeshVertexPrinter)
    printers.add_printer("MeshTriangle", "^footfall::detail::MeshTriangle$", MeshTrianglePrinter)
    printers.add_printer("TriangleMesh", "^footfall::detail::TriangleMesh<", CountsPrinter)
    printers.add_printer("WalkableMesh", "^footfall::detail::WalkableMesh$", CountsPrinter)
    printers.add_printer("NavigationMesh", "^footfall::NavigationMesh$", CountsPrinter)
    printers.add_printer("Environment", "^footfall::Environment$", CountsPrinter)
    printers.add_printer("TriangleSoup", "^footfall::TriangleSoup$", CountsPrinter)
    return printers


gdb.printing.register_pretty_printer(None, make_printers(), replace=True)
