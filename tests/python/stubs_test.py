# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""The stubs say what the module has, no more and no less, and all of it is documented."""
import ast
import inspect
import pathlib

import clothfit

STUBS = ast.parse(pathlib.Path(clothfit.__file__).with_name("__init__.pyi").read_text())


def stub_names(body):
    return {
        node.name
        for node in body
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("__")
    }


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_the_same_names():
    assert stub_names(STUBS.body) == set(clothfit.__all__)
    classes = [node for node in STUBS.body if isinstance(node, ast.ClassDef)]
    assert len(classes) > 5
    for node in classes:
        if node.name != "InputError":
            assert stub_names(node.body) == public(getattr(clothfit, node.name)), node.name


def test_the_same_arguments():
    functions = [node for node in STUBS.body if isinstance(node, ast.FunctionDef)]
    assert len(functions) == 2
    for node in functions:
        stub = [arg.arg for arg in node.args.args + node.args.kwonlyargs]
        # pybind11 writes the signature on the docstring's first line.
        first = inspect.getdoc(getattr(clothfit, node.name)).splitlines()[0]
        places = [first.index(name + ":") for name in stub]
        assert places == sorted(places) and first.count(": ") >= len(stub)


def test_everything_is_documented():
    for name in clothfit.__all__:
        assert inspect.getdoc(getattr(clothfit, name)), name
