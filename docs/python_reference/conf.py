# Configuration of Sphinx for the reference of the Python package; docs/make_reference.sh runs it.
# SPDX-License-Identifier: GPL-3.0-or-later
import ast
import inspect
import pathlib
import re

import footfall

project = "Footfall for Python"
release = footfall.__version__
extensions = ["sphinx.ext.autodoc"]
exclude_patterns = ["_build"]
default_role = "py:obj"  # `WalkableArea` is a link
html_theme = "alabaster"
html_theme_options = {"description": "Exact walkable areas of 3D environments", "page_width": "70em"}
html_show_copyright = False
html_show_sourcelink = False
autoclass_content = "both"  # of the class, and of its constructor
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "inherited-members": "list,ValueError,RuntimeError", "show-inheritance": True}
ARGUMENT = re.compile(r"(\w+(?:, \w+)*): (?=\S)")


def stub_signatures(body, prefix="footfall."):
    """The signatures that the stub has of each name: arguments with their types, and the type of the result."""
    found = {}
    for node in body:
        if isinstance(node, ast.ClassDef):
            found.update(stub_signatures(node.body, prefix + node.name + "."))
        elif isinstance(node, ast.FunctionDef):
            if node.args.args and node.args.args[0].arg == "self":
                del node.args.args[0]
            result = "" if node.name == "__init__" else f" -> {ast.unparse(node.returns)}"
            found.setdefault(prefix + node.name, []).append(f"({ast.unparse(node.args)}){result}")
    return found


STUB = stub_signatures(ast.parse(pathlib.Path(footfall.__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body)


def arguments_of(what, thing):
    """The names of the arguments of a function, or of the constructor of a class."""
    try:
        return set(inspect.signature(thing.__init__ if what == "class" else thing).parameters)
    except (TypeError, ValueError):
        return set()


def as_restructured_text(app, what, name, thing, options, lines):
    """Docstrings are written for help(): arguments become a list, indented paragraphs become code."""
    names, result, in_argument = arguments_of(what, thing), [], False
    for line in lines:
        found = ARGUMENT.match(line)
        if found and names.issuperset(found.group(1).split(", ")):
            if not in_argument and result and result[-1]:
                result.append("")
            in_argument = True
            line = f"* **{found.group(1)}**: {line[found.end():]}"
        elif not line:
            in_argument = False
        elif in_argument:
            line = "  " + line.strip()  # the text of an argument goes on to the next blank line
        elif line.startswith("    ") and not (result and result[-1]):
            result += ["::", ""]
        result.append(line)
    if what == "property" and name in STUB:
        result += ["", f":type: ``{STUB[name][0].partition(' -> ')[2]}``"]
    lines[:] = result


def with_types(app, what, name, thing, options, signature, returns):
    """Signatures of the stub, one a line. Classes that cannot be made in Python have no arguments."""
    known = STUB.get(name + ".__init__" if what == "class" else name)
    if known and what != "property":
        return "\n".join(known), ""
    return ("", "") if what == "class" and signature == "(*args, **kwargs)" else None


def known_bases(app, name, thing, options, bases):
    bases[:] = [base for base in bases if base.__name__ != "pybind11_object"] or [object]


def setup(app):
    app.connect("autodoc-process-docstring", as_restructured_text)
    app.connect("autodoc-process-signature", with_types)
    app.connect("autodoc-process-bases", known_bases)
