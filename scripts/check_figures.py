#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks that measured figures stand only in tables that scripts/make_tables.py writes: check_figures.py [ROOT].
Prints file:line of times, amounts of memory, percentages and ratios in sentences of the manual, of README.md
and of CHANGES.md, of tables of figures that are typed in, and of tables that no page includes or no benchmark makes.
Prints drawings that do not scale with the page, too.
Exits with 1 if there is any."""

import re
import sys
from pathlib import Path

import check_prose
import make_tables

NUMBER = r"(?:\d[\d,.]*|twice|half|a third|two|three|four|five|six|seven|eight|nine|ten)"
UNIT = r"(?:(?:nano|micro|milli)?seconds?|minutes?|hours?|(?:mega|giga)bytes|percent)"
# `check_prose.prepared()` replaces the letter in microseconds by an x.
FIGURES = [re.compile(pattern) for pattern in (
    r"\d[\d,.]* ?(?:ns|ms|s|xs|[kMG]B|%)(?!\w)",
    rf"\b{NUMBER}(?: of an?)? {UNIT}\b",
    rf"\b{NUMBER} (?:times )?as (?:fast|long|slow|much)\b",
    rf"\b{NUMBER} times (?:more|less|faster|slower|longer|shorter|smaller|larger)\b",
    rf"\b{NUMBER}(?: times)? the (?:time|memory)\b",
    rf"\b{NUMBER} less (?:time|memory|work)\b",
    r"\bfactor of \d[\d,.]*",
)]

# What sentences of a page may say: parameters, bounds and definitions are not measured.
DEFINITIONS = [
    ("Benchmarks.txt", r"100 times as long as thick"),
    ("Refinement.txt", r"within 10 %"),
]

# Tables that are not measured, by page and first heading. A test counts the bytes of "part".
DEFINED_TABLES = [
    ("Benchmarks.txt", "part"), ("Guarantees.txt", "promise"), ("Program.txt", "exit code"),
    ("Simplification.txt", "mass"), ("Viewer.txt", "color"),
]


def text_of(path):
    """Returns sentences and tables, on their lines, without code and formulas."""
    return check_prose.prepared(path.read_text().replace("/*!", "").replace("*/", ""))


def figures_in_sentences(path):
    text = text_of(path)
    one_line = text.replace("\n", " ")
    for page, phrase in DEFINITIONS:
        if page == path.name:
            one_line = re.sub(phrase, lambda match: " " * len(match[0]), one_line)
    for pattern in FIGURES:
        for found in pattern.finditer(one_line):
            line = text.count("\n", 0, found.start()) + 1
            yield line, f'"{found[0]}" belongs into a table of scripts/make_tables.py'


def typed_tables(path):
    lines = text_of(path).split("\n")
    for number, (headings, rule) in enumerate(zip(lines, lines[1:]), 1):
        if re.fullmatch(r"\|[ :|-]*-: *\|[ :|-]*", rule.strip()):
            first = headings.strip("| ").split("|")[0].strip()
            if (path.name, first) not in DEFINED_TABLES:
                yield number, f'the table "{first}" is typed in'


def included_tables(page):
    """Returns the files of tables that a page includes."""
    for name in re.findall(r"^\\include\{doc\} (\S+)$", page.read_text(), re.MULTILINE):
        yield page.parent / "tables" / name


def orphans(pages):
    """Returns tables that no page includes, or no benchmark makes, and the other way round."""
    included = {table for page in pages for table in included_tables(page)}
    files = [file for run in make_tables.RUNS for file in run.files if file != "-"]
    made = {make_tables.path_of(file) for file in [*files, make_tables.SUMMARY_FILE]}
    for table in sorted(included | made | set(make_tables.ROOT.glob("doc/*/tables/*"))):
        name = table.relative_to(make_tables.ROOT)
        if not table.exists():
            yield f"{name} does not exist"
        elif table not in included:
            yield f"{name}: no page includes it"
        elif table not in made:
            yield f"{name}: scripts/make_tables.py does not make it"


def other_summary():
    """Returns the file of the summary if it differs from the tables."""
    path = make_tables.path_of(make_tables.SUMMARY_FILE)
    if path.exists() and path.read_text() != make_tables.summary() + "\n":
        yield f"{path.relative_to(make_tables.ROOT)}: the summary differs from the tables"


def drawings_of_one_size():
    """Returns drawings without a viewBox: windows that are narrower cut them off."""
    for path in sorted(make_tables.ROOT.glob("doc/*/fig/*.svg")):
        if " viewBox=" not in path.read_text().split(">", 1)[0]:
            yield f"{path.relative_to(make_tables.ROOT)}: a drawing without a viewBox"


def main():
    if len(sys.argv) > 1:
        make_tables.ROOT = Path(sys.argv[1]).resolve()
    pages = sorted(make_tables.ROOT.glob("doc/*/*.txt"))
    found = [*orphans(pages), *other_summary(), *drawings_of_one_size()]
    for page in [*pages, make_tables.ROOT / "README.md", make_tables.ROOT / "CHANGES.md"]:
        for line, message in sorted([*figures_in_sentences(page), *typed_tables(page)]):
            found.append(f"{page.relative_to(make_tables.ROOT)}:{line}: {message}")
    if found:
        print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
