# SPDX-License-Identifier: GPL-3.0-or-later
# Wrong arguments in one sentence, in place of pybind11's list of signatures. A call that is right costs nothing more: the
# arguments are looked at only when pybind11 has refused them.
import functools
import inspect
import os
import re

from . import _core

_AGENT_NUMBERS = ("slope", "height", "step", "gap", "radius", "drop", "minimum_area")
_LARGEST = 2**31 - 1


def _split(text, separator):
    """Split a text where brackets and quotes are closed."""
    parts, depth, quote, start = [], 0, None, 0
    for i, character in enumerate(text):
        if quote:
            quote = None if character == quote and text[i - 1] != "\\" else quote
        elif character in "'\"":
            quote = character
        elif character in "([{<":
            depth += 1
        elif character in ")]}>" and text[i - 1:i + 1] != "->":
            depth -= 1
        elif depth == 0 and text.startswith(separator, i):
            parts.append(text[start:i])
            start = i + len(separator)
    return parts + [text[start:]]


def _types(message):
    """{argument: type} from pybind11's message about arguments that it refuses."""
    found = re.search(r"^\s+1\. [\w.]*\((.*)\)(?: -> .*)?$", message, re.MULTILINE)
    types = {}
    for argument in _split(found.group(1), ", ") if found else ():
        name, _, kind = argument.partition(": ")
        types[name.strip()] = _split(kind, " = ")[0].strip()
    return types


def _fits(kind, value):
    """None where a value is of a type of pybind11's, else (error, what is accepted)."""
    outer = re.fullmatch(r"(Optional|Union)\[(.*)\]", kind)
    if outer:
        kinds = _split(outer.group(2), ", ")
        if outer.group(1) == "Optional" and value is None:
            return None
        refused = [_fits(k, value) for k in kinds]
        if None in refused:
            return None
        accepted = [text for _, text in refused] + (["None"] if outer.group(1) == "Optional" else [])
        return refused[0][0], " or ".join(accepted)
    if kind == "int":
        if isinstance(value, int) or hasattr(type(value), "__index__"):
            outside = not 0 <= value.__index__() <= _LARGEST
            return (_core.InputError, f"a whole number from 0 to {_LARGEST}") if outside else None
        return TypeError, "a whole number"
    if kind == "float":
        try:
            return None if not isinstance(value, str) and float(value) is not None else (TypeError, "a number")
        except OverflowError:
            return _core.InputError, "a number that a float can hold"
        except (TypeError, ValueError):
            return TypeError, "a number"
    if kind == "bool":
        return None if hasattr(type(value), "__bool__") else (TypeError, "True or False")
    if kind == "str":
        return None if isinstance(value, str) else (TypeError, "a text")
    if kind.endswith("Path") or kind.endswith("PathLike"):
        try:
            os.fspath(value)
        except TypeError:
            return TypeError, "the name of a file"
        return None
    known = getattr(_core, kind.rpartition(".")[2], None)
    if isinstance(known, type):
        return None if isinstance(value, known) else (TypeError, "a footfall." + known.__name__)
    return None


def with_article(name):
    return ("an " if name[:1] in "AEIOUaeiou" else "a ") + name


def _shown(value):
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        text = repr(value) if not isinstance(value, int) or abs(value) < 10**20 else "this number"
        return f"{text} is not accepted"
    return ("None" if value is None else with_article(type(value).__name__)) + " is not accepted"


def _wrong(name, native, args, kwargs, message):
    """The exception for a call that pybind11 refused; None where the reason is not found."""
    parameters = [p for p in inspect.signature(native).parameters.values()]
    is_method = bool(parameters) and parameters[0].name == "self"
    if is_method:
        parameters, args = parameters[1:], args[1:]
    names = [p.name for p in parameters]
    by_place = [p.name for p in parameters if p.kind is not inspect.Parameter.KEYWORD_ONLY]
    for keyword, value in kwargs.items():
        if keyword in names:
            continue
        hint = "give " + ", ".join(names) if names else "it takes none"
        if keyword in _AGENT_NUMBERS and "pipeline" in names:
            hint = f"it is a number of an agent: give footfall.Agent({keyword}={value!r}) as the pipeline"
        return TypeError(f"{name}(): there is no argument '{keyword}'; {hint}")
    if len(args) > len(by_place):
        others = names[len(by_place):]
        hint = "; give " + ", ".join(others) + " by name" if others else ""
        return TypeError(f"{name}(): {len(args)} arguments are given by place, and {len(by_place)} are accepted{hint}")
    given = dict(zip(by_place, args))
    for keyword in kwargs:
        if keyword in given:
            return TypeError(f"{name}(): the argument '{keyword}' is given twice; give it by place or by name")
    given.update(kwargs)
    for parameter in parameters:
        if parameter.default is inspect.Parameter.empty and parameter.name not in given:
            return TypeError(f"{name}(): the argument '{parameter.name}' is missing; give " + ", ".join(names))
    types, defaults = _types(message), {p.name: p.default for p in parameters}
    for argument, value in given.items():
        refused = _fits(types.get(argument, "object"), value)
        if refused:
            kind, accepted = refused
            if defaults.get(argument, 0) is None and not accepted.endswith("None"):
                accepted += " or None"
            return kind(f"{name}(): {argument}: {_shown(value)}; give {accepted}")
    return None


def checked(native, name):
    """A function around one of the module's: help() shows it as one, pickle finds it by its name, and wrong arguments
    are told in one sentence."""

    @functools.wraps(native)
    def function(*args, **kwargs):
        try:
            return native(*args, **kwargs)
        except TypeError as error:
            message = str(error)
            if "): incompatible " not in message.partition("\n")[0]:
                raise
            told = _wrong(name, native, args, kwargs, message)
            if told is None:
                raise
        raise told

    return function


def _checked_index(native, name):
    """The same for `__getitem__`, whose only argument has no name."""

    @functools.wraps(native)
    def function(self, index):
        if not hasattr(type(index), "__index__"):
            raise TypeError(f"{name}[...]: {_shown(index)}; give a whole number")
        return native(self, index)

    return function


def check_methods(kind):
    """Put `checked` around the methods of a class, and around its constructor."""
    for name, member in list(vars(kind).items()):
        is_method = inspect.isroutine(member) and not name.startswith("_")
        if is_method:
            setattr(kind, name, checked(getattr(kind, name), f"{kind.__name__}.{name}"))
        elif name == "__getitem__":
            setattr(kind, name, _checked_index(getattr(kind, name), kind.__name__))
        elif name == "__init__":
            setattr(kind, name, checked(getattr(kind, name), kind.__name__))
