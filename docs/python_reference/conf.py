# Configuration of Sphinx for the reference of the Python package; docs/make_reference.sh runs it.
# SPDX-License-Identifier: GPL-3.0-or-later
import inspect
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
    lines[:] = result


def without_placeholder(app, what, name, thing, options, signature, returns):
    """Classes that cannot be made in Python have no arguments."""
    return ("", "") if what == "class" and signature == "(*args, **kwargs)" else None


def known_bases(app, name, thing, options, bases):
    bases[:] = [base for base in bases if base.__name__ != "pybind11_object"] or [object]


def setup(app):
    app.connect("autodoc-process-docstring", as_restructured_text)
    app.connect("autodoc-process-signature", without_placeholder)
    app.connect("autodoc-process-bases", known_bases)
