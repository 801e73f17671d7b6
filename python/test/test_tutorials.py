# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the scripts of the tutorial and the example of the README; they check what they claim."""

import contextlib
import io
import os
import re
import runpy
import unittest
from pathlib import Path

FOLDER = Path(os.environ["INTRINSIC_PYTHON_DIR"])


class Tutorials(unittest.TestCase):
    def test_scripts(self):
        scripts = sorted(FOLDER.glob("tutorial/*.py"))
        self.assertEqual(len(scripts), 6)
        for script in scripts:
            with self.subTest(script=script.name), contextlib.redirect_stdout(io.StringIO()):
                runpy.run_path(str(script))

    def test_readme(self):
        text = (FOLDER.parent / "README.md").read_text(encoding="utf-8")
        (block,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        names = {}
        exec(block, names)
        n = len(names["V"])
        self.assertEqual((names["L"].shape, names["d"].shape, names["P"].shape), ((n, n), (n,), (n, 200)))
        self.assertEqual(names["d"][0], 0)
        self.assertEqual(names["pieces"].uv.shape[1:], (3, 2))


if __name__ == "__main__":
    unittest.main()
