# SPDX-License-Identifier: GPL-3.0-or-later
"""The type stubs and the help say what the module has: names, signatures, defaults, docstrings."""

import ast
import inspect
import pathlib
import pydoc
import unittest

import footfall

TREE = ast.parse(pathlib.Path(footfall.__file__).with_suffix(".pyi").read_text())
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef)}


def of_stub(function):
    """(name, kind, default) of each argument, self left out."""
    arguments = function.args
    assert not arguments.posonlyargs and not arguments.vararg and not arguments.kwarg, function.name
    missing = [None] * (len(arguments.args) - len(arguments.defaults))
    found = []
    for kind, names, defaults in [
        (inspect.Parameter.POSITIONAL_OR_KEYWORD, arguments.args, missing + arguments.defaults),
        (inspect.Parameter.KEYWORD_ONLY, arguments.kwonlyargs, arguments.kw_defaults),
    ]:
        for name, default in zip(names, defaults):
            value = inspect.Parameter.empty if default is None else ast.literal_eval(default)
            found.append((name.arg, kind, value))
    return [argument for argument in found if argument[0] != "self"]


def of_module(function):
    parameters = inspect.signature(function).parameters.values()
    return [(p.name, p.kind, p.default) for p in parameters if p.name != "self"]


def public(names):
    return sorted(name for name in names if not name.startswith("_"))


def members_of_stub(node):
    properties, methods = [], {}
    for member in node.body:
        if isinstance(member, ast.FunctionDef):
            names = [d.id for d in member.decorator_list]
            assert names in ([], ["property"]), member.name
            if names:
                properties.append(member.name)
            else:
                methods[member.name] = member
    return properties, methods


class Stubs(unittest.TestCase):
    def test_names(self):
        self.assertEqual(sorted([*CLASSES, *FUNCTIONS]), sorted(footfall.__all__))
        self.assertEqual(public(vars(footfall)), sorted(footfall.__all__))

    def test_functions(self):
        for name, node in FUNCTIONS.items():
            with self.subTest(name):
                self.assertEqual(of_stub(node), of_module(getattr(footfall, name)))

    def test_classes(self):
        for name, node in CLASSES.items():
            kind = getattr(footfall, name)
            with self.subTest(name):
                self.assertEqual(kind.__module__, "footfall")
                bases = [b.__name__ for b in kind.__bases__ if b.__name__ != "pybind11_object"]
                self.assertEqual([getattr(b, "value", b).id for b in node.bases], bases)
                properties, methods = members_of_stub(node)
                self.assertEqual(sorted(properties),
                                 public(n for n, member in vars(kind).items() if isinstance(member, property)))
                self.assertEqual(public(methods),
                                 public(n for n, member in vars(kind).items() if inspect.isroutine(member)))
            for method, stub in methods.items():
                with self.subTest(name + "." + method):
                    if method in ("__len__", "__getitem__"):
                        self.assertIn(method, vars(kind))
                    else:
                        self.assertEqual(of_stub(stub), of_module(getattr(kind, method)))


class Help(unittest.TestCase):
    def test_everything_has_a_docstring(self):
        for name in footfall.__all__:
            item = getattr(footfall, name)
            self.assertTrue(item.__doc__, name)
            for member, value in vars(item).items() if inspect.isclass(item) else ():
                if not member.startswith("_"):
                    self.assertTrue(value.__doc__, name + "." + member)

    def test_help_shows_signatures_shapes_and_units(self):
        text = pydoc.plain(pydoc.render_doc(footfall))
        for wanted in [
            "walkable_area(vertices, triangles, slope=45.0, height=2.0, *, minimum_area=1.0, step=0.4, gap=0.05, "
            "radius=0.0, drop=0.0, up='z'",
            "vertices: shape (n, 3), float64",
            "find_path(self, start, target, *, reach=None)",
            "slope: degrees, above 0 and below 90",
            "class WalkableArea(NavigationMesh)",
        ]:
            self.assertIn(wanted, text)
        self.assertNotIn("_core.", text)
        self.assertNotIn("PyCapsule", text)


if __name__ == "__main__":
    unittest.main()
