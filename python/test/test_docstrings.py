# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the examples in docstrings, checks that each public function has one, and checks types."""

import doctest
import importlib
import inspect
import os
import pkgutil
import re
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np

import intrinsic

MODULES = ["intrinsic"] + [f"intrinsic.{m.name}" for m in pkgutil.iter_modules(intrinsic.__path__)
                           if m.name != "_core"]


class Docstrings(unittest.TestCase):
    def test_examples(self):
        count = 0
        for name in MODULES:
            with np.printoptions(legacy=False):
                result = doctest.testmod(importlib.import_module(name))
            self.assertEqual(result.failed, 0, name)
            count += result.attempted
        self.assertGreater(count, 60)

    def test_triangulations_as_surfaces(self):
        """The text about V mentions a Triangulation if the function takes it."""
        T, count = intrinsic.Triangulation(*intrinsic.shapes.icosphere(1)), 0
        more = {"simplify": {"n": 9}, "show": {"open": False}}
        for name in intrinsic.__all__:
            thing = getattr(intrinsic, name)
            is_called = inspect.isfunction(thing) or name in ("DistanceSolver", "Triangulation")
            if not is_called or "V" not in inspect.signature(thing).parameters:
                continue
            try:
                thing(T, **more.get(name, {}))
                is_taken = True
            except intrinsic.IntrinsicError as error:
                is_taken = "takes a mesh" not in str(error)
            text = self.about_surface(name)
            if text:
                count += 1
                admits = "Triangulation" in text and "no Triangulation" not in text
                self.assertEqual(admits, is_taken, f"{name}: {text}")
        self.assertGreater(count, 20)

    def about_surface(self, name):
        """Return the text of a docstring about V, with the texts to which it refers."""
        found = re.search(r"^V\b.*\n((?:    .*\n)+)", inspect.getdoc(getattr(intrinsic, name)), re.M)
        text = found[1] if found else ""
        return text + "".join(map(self.about_surface, re.findall(r"As of `(\w+)\(\)`", text)))

    def test_everything_is_described(self):
        for name in intrinsic.__all__:
            thing = getattr(intrinsic, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (
                            inspect.isfunction(value) or isinstance(value, property)):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


class Types(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "needs mypy")
    def test_package(self):
        version = subprocess.run(["mypy", "--version"], capture_output=True, text=True, check=True)
        if not version.stdout.startswith("mypy 1.0."):
            self.skipTest("other versions of mypy and numpy object to other things")
        folder = Path(os.environ["INTRINSIC_PYTHON_DIR"])
        done = subprocess.run(
            ["mypy", "--config-file", str(folder / "mypy.ini"), "--cache-dir", os.devnull,
             "--no-incremental", "-p", "intrinsic"], cwd=folder, capture_output=True, text=True,
            check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_stub_names_what_is_there(self):
        import ast

        stub = Path(intrinsic.__path__[0], "_core.pyi").read_text()
        for node in ast.parse(stub).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                thing = getattr(intrinsic._core, node.name)
                for member in node.body if isinstance(node, ast.ClassDef) else []:
                    self.assertTrue(hasattr(thing, member.name), f"{node.name}.{member.name}")


if __name__ == "__main__":
    unittest.main()
