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
        with contextlib.redirect_stdout(io.StringIO()) as output:
            exec(block, {})
        self.assertIn("flips", output.getvalue())


if __name__ == "__main__":
    unittest.main()
