# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tests that scripts/check_prose.py finds violations of its rules, on the right lines, and nothing else:
check_prose.py SCRIPT."""

import importlib.util
import sys
import tempfile
from pathlib import Path

specification = importlib.util.spec_from_file_location("check_prose", sys.argv[1])
check_prose = importlib.util.module_from_spec(specification)
specification.loader.exec_module(check_prose)

WORDS = " ".join(["word"] * 24)

# Names of files, their text, and the lines with violations.
CASES = [
    ("a.txt", f"A {WORDS}.\n\nA {WORDS} too.\n", [3]),
    ("a.txt", f"A {WORDS}. Then {WORDS}.\nBut {WORDS} more.", [2]),
    ("a.txt", f"A {WORDS}\n\nanother paragraph of a few words.\n", []),
    ("a.txt", f"- a {WORDS}\n- an item of its own\n", []),
    ("a.txt", f"| a {WORDS} | another cell |\n", []),
    ("a.txt", "A formula \\f$a + b + c + d + e + f + g + h + i + j + k + l + m\\f$ counts as one word.\n", []),
    ("a.txt", f"`a few words in a name` and {WORDS}.\n", [1]),
    ("a.txt", f"See \\ref it_section \"a title of some words\" and more.\n\\code\nx {WORDS} {WORDS}\n\\endcode\n", []),
    ("a.txt", f"Text:\n\n    indented code {WORDS} {WORDS}\n\nText.\n", []),
    ("a.txt", f"The length is\n\\f[\n  a = b, \\qquad (1)\n\\f]\nwhere a {WORDS}.\n", [5]),
    ("a.txt", "Its length is\nthat of the other.\n", [2]),
    ("a.txt", "Those of the input stay. The input has those.\n", [1, 1]),
    ("a.txt", "Those faces stay. There is one, and there are two.\n", []),
    ("a.txt", "It goes on from there. What is new, the parts of which all are known.\n", [1, 1, 1]),
    ("a.txt", "The place of a vertex is in doubt, so it restarts anew.\n", [1, 1, 1]),
    ("a.txt", "The call takes place in place, to 9 decimal places.\n", []),
    ("a.txt", f"- \\anchor cite_A [A] A. Author. *{WORDS} {WORDS}.* Journal, 2000.\n", []),
    ("a.md", f"```\nthat of {WORDS} {WORDS}\n```\n", []),
    ("a.h", f"// Copyright of those of whom.\nint f(); // that of g\n/// returns {WORDS} too.\n", [3]),
    ("a.h", "/// returns the value of those.\n///\n/// \\param x that of `f()`\nint f(int x);\n", [1, 3]),
    ("a.h", f"// Returns {WORDS}.\n/// returns {WORDS}.\nint a; ///< the place of a\n", [3]),
    ("a.h", "// the length\nint f();\n// Returns it\n//\n// by name.\nint g();\n", [1, 1, 3, 5]),
    ("a.h", "// Returns it.\n// \\pre `f` is set\nint f(); // of g\n         // and h\n// ---- Queries ----\n", []),
    ("a.h", "/// \\ingroup Package\n/// returns it.\nint f();\n/// \\ingroup Package returns it.\nint g();\n", [4]),
    ("demo/a.cpp", f'auto help =\n  R"(Words:\n  free  those of\n  disk  a {WORDS}\n\nMore.)";\n', [3]),
    ("a.py", f'"""A {WORDS} too.\n"""\n# that of\ndef f():\n    """Return that of `f`."""\n', [1, 5]),
    ("a.py", f'"""Words.\n\nAttributes\n----------\na : those of {WORDS}\n    A {WORDS}.\n>>> 1\nthose of\n"""\n', []),
]


def lines_with_violations(name, text):
    with tempfile.TemporaryDirectory() as folder:
        check_prose.ROOT = Path(folder)
        path = Path(folder) / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        return sorted(line for line, _ in check_prose.violations(path))


failures = 0
for name, text, expected in CASES:
    found = lines_with_violations(name, text)
    if found != expected:
        failures += 1
        print(f"{text!r}: violations on lines {found} instead of {expected}")
sys.exit(1 if failures else 0)
