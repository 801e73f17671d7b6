# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes the pages of examples of the manuals, and files examples/PACKAGE/printed.txt with what the
examples print: examples_page.py PROGRAMS, the directory of the compiled examples. With --check NAME,
PROGRAMS is the one that runs this example, and what it prints is compared with this file, if it is
there: integers up to 2 or 5 %, other numbers up to a relative difference of 0.001."""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parent / "examples"
PACKAGES = ["Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification"]
MOST_LINES = 4

INTRODUCTION = """/*!
\\page Chapter_Examples_PACKAGE Examples

Without the name of a mesh, programs read a mesh of CGAL's data. Their output is in
`examples/PACKAGE/printed.txt`.

| program | what it does |
| ------- | ------------ |
"""


def expectations(package):
    return EXAMPLES / package / "printed.txt"


def comment(source):
    """The first sentence of the first comment after the copyright."""
    for block in re.findall(r"(?:^//.*\n)+", source.read_text(), re.M):
        if "Copyright" not in block:
            text = " ".join(line[2:].strip() for line in block.split("\n")[:-1])
            return re.split(r"(?<=\.) (?=[A-Z])", text)[0]
    raise ValueError(f"{source} has no comment")


def printed(program, name):
    with tempfile.TemporaryDirectory() as scratch: # some write files
        result = subprocess.run([program.resolve(), name], cwd=scratch, stdout=subprocess.PIPE,
                                text=True, check=True)
    lines = result.stdout.split("\n")[:-1]
    return lines if len(lines) <= MOST_LINES else lines[:MOST_LINES] + ["..."]


def row(package, source):
    return f"| \\ref {package}/{source.name} | {comment(source)} |\n"


def blocks(text):
    """What each example prints according to a file, by name."""
    found = re.findall(r"^(\w+)\n((?:    .*\n)*)", text, re.M)
    return {name: [line[4:] for line in block.split("\n")[:-1]] for name, block in found}


NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


def agree(a, b):
    """Whether two lines are equal up to rounding, which can change numbers of steps and of tiny faces, too."""
    def are_near(x, y):
        is_integer = "." not in x + y and "e" not in x + y
        absolute, relative = (2, 0.05) if is_integer else (1e-9, 1e-3)
        return abs(float(x) - float(y)) <= absolute + relative * max(abs(float(x)), abs(float(y)))

    if re.sub(NUMBER, "#", a) != re.sub(NUMBER, "#", b):
        return False
    return all(map(are_near, re.findall(NUMBER, a), re.findall(NUMBER, b)))


def check(name, program):
    lines = printed(program, name)
    print(*lines, sep="\n")
    expected = {k: v for package in PACKAGES for k, v in blocks(expectations(package).read_text()).items()}
    expected = expected.get(name, lines)
    if len(expected) != len(lines) or not all(map(agree, expected, lines)):
        sys.exit(f"{name} prints something else than printed.txt says")


def write(package, programs):
    page, prints = INTRODUCTION.replace("PACKAGE", package), []
    for source in sorted((EXAMPLES / package).glob("*.cpp")):
        page += row(package, source)
        if not source.stem.endswith("_with_Qt"): # they open windows
            lines = printed(programs / f"examples_{package}", source.stem)
            prints.append("\n".join([source.stem] + ["    " + line for line in lines]) + "\n")
    (HERE / package / "Examples.txt").write_text(page + "*/\n")
    expectations(package).write_text("\n".join(prints))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", type=Path)
    parser.add_argument("--check", metavar="NAME")
    arguments = parser.parse_args()
    if arguments.check:
        check(arguments.check, arguments.programs)
    else:
        for package in PACKAGES:
            write(package, arguments.programs)


main()
