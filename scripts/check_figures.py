#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks that measured figures stand only in tables that scripts/make_tables.py writes: check_figures.py [ROOT].
Prints file:line of times, amounts of memory, percentages and ratios in sentences of the manual and of
README.md, of tables of figures that are typed in, and of tables that no page includes or no benchmark makes.
Exits with 1 if there is any."""

import re
import sys
from pathlib import Path

import check_prose
import make_tables

NUMBER = r"(?:\d[\d,.]*|half|twice|(?:a |one )?(?:third|fourth|fifth|tenth)|two|three|four|five|six|seven|eight|nine|ten)"
FIGURES = [re.compile(pattern) for pattern in (
    r"\d ?(?:ns|ms|s|&micro;s|x0|[kMG]B|%)(?!\w)",
    r"\d (?:(?:micro|milli)?seconds?|minutes?|hours?|(?:mega|giga)?bytes|percent)\b",
    rf"\b{NUMBER} (?:seconds?|minutes?|hours?|percent)\b|\bthird of a second\b",
    rf"\b{NUMBER} (?:times )?(?:as|more|less|faster|slower|longer|shorter) (?:fast|long|slow|much|memory|time)?\b",
    rf"\b{NUMBER} times (?:faster|slower|longer|shorter|the)\b|\b(?:twice|half|third of) the (?:time|memory)\b",
    r"\bfactor of \d",
)]

# What a sentence may say: parameters, bounds and definitions are not measured. Pages and phrases.
DEFINITIONS = [
]

# Tables that are no measurements, by page and first heading.
DEFINED_TABLES = [
]


def page_lines(path):
    """Returns numbered lines of sentences and of tables, without code and formulas."""
    text = path.read_text().replace("/*!", "").replace("*/", "")
    if path.suffix == ".md":
        text = without_summary(text)
    return list(enumerate(check_prose.prepared(text).split("\n"), 1))


def without_summary(text):
    """Replaces the table that make_tables.py writes by empty lines."""
    return make_tables.SUMMARY_BLOCK.sub(lambda block: "\n" * block[0].count("\n"), text)


def figures_in_sentences(path):
    for line, text in page_lines(path):
        for phrase in [phrase for page, phrase in DEFINITIONS if page == path.name]:
            text = re.sub(phrase, "", text)
        found = next(filter(None, (pattern.search(text) for pattern in FIGURES)), None)
        if found:
            yield line, f'"{found[0]}" belongs into a table of scripts/make_tables.py'


def typed_tables(path):
    lines = page_lines(path)
    for (line, headings), (_, rule) in zip(lines, lines[1:]):
        if re.fullmatch(r"\|[ :|-]*-: *\|[ :|-]*", rule.strip()):
            first = headings.strip("| ").split("|")[0].strip()
            if (path.name, first) not in DEFINED_TABLES:
                yield line, f'the table "{first}" is typed in'


def included_tables(path):
    """Returns pairs of a line and the file of a table."""
    for line, text in enumerate(path.read_text().split("\n"), 1):
        if included := re.match(r"\\include\{doc\} (\S+)$", text):
            yield line, path.parent / "tables" / included[1]


def orphans(root, pages):
    """Returns tables that no page includes, or no benchmark makes, and the other way round."""
    included = {table for page in pages for _, table in included_tables(page)}
    made = {root / make_tables.path_of(file).relative_to(make_tables.ROOT)
            for run in make_tables.RUNS for file in run.files if file != "-"}
    made.add(root / make_tables.SUMMARY_FILE.relative_to(make_tables.ROOT))
    for table in sorted(included | made | set(root.glob("doc/*/tables/*"))):
        name = table.relative_to(root)
        if not table.exists():
            yield f"{name} does not exist"
        elif table not in included:
            yield f"{name}: no page includes it"
        elif table not in made:
            yield f"{name}: scripts/make_tables.py does not make it"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else make_tables.ROOT).resolve()
    pages = sorted(root.glob("doc/*/*.txt"))
    found = list(orphans(root, pages))
    for page in [*pages, root / "README.md"]:
        for line, message in sorted([*figures_in_sentences(page), *typed_tables(page)]):
            found.append(f"{page.relative_to(root)}:{line}: {message}")
    if make_tables.summary_of(root / "README.md") != (root / make_tables.SUMMARY_FILE.relative_to(make_tables.ROOT)).read_text().strip():
        found.append("README.md: the summary is not the summary of the tables")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
