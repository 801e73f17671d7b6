#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Follows the questions of the first page of each manual: check_questions.py DOC, the folder with
PACKAGE/html. Every question has links, each to a section that exists. These sections name every function,
class and option of the answer. Prints each violation, and exits with 1 if there is any."""

import html
import re
import sys
from pathlib import Path

# First pages and headings of their tables. From the first page of the first package, the others are one click.
TABLES = [("Intrinsic_triangulations", "it_tasks"), ("Discrete_conformal_maps", "dcm_tasks"),
          ("Intrinsic_simplification", "is_tasks")]
FEWEST_QUESTIONS = 30


def plain(text):
    return html.unescape(re.sub(r"<[^>]*>", " ", text))


def section(page, anchor):
    """Returns the HTML from an anchor to the next heading of its level, or the whole page without an anchor."""
    text = page.read_text()
    if not anchor:
        return text
    start = text.find(f'id="{anchor}"')
    if start < 0:
        return None
    heading = re.search(r"<h([1-6])[^>]*>(?:<[^>]*>)*<[^>]*$", text[:start].rsplit("\n", 1)[-1])
    level = heading[1] if heading else "1"
    end = re.search(rf"<h[1-{level}][ >]", text[start:])
    return text[start:start + end.start()] if end else text[start:]


def questions(folder, anchor):
    """Rows of the table of a first page: the question, its answer, and targets of its links."""
    for row in re.findall(r"<tr.*?</tr>", section(folder / "index.html", anchor), re.S):
        cells = re.findall(r"<td.*?</td>", row, re.S)
        links = re.findall(r'href="([^"#]*)(?:#([^"]*))?"', row)
        if cells and len("".join(map(plain, cells[1:])).strip()) > 0:
            code = re.findall(r"<code>.*?</code>|<a [^>]*>[A-Z]\w*_\w*</a>", "".join(cells[1:-1]))
            yield " ".join(plain(cells[0]).split()), " ".join(map(plain, code)), links


def complaints(doc):
    number = 0
    for package, anchor in TABLES:
        folder = doc / package / "html"
        for question, answer, links in questions(folder, anchor):
            number += 1
            found = ""
            if not links:
                yield f"{package}: no link answers: {question}"
            for page, target in links:
                path = (folder / page).resolve()
                text = section(path, target) if path.exists() else None
                if text is None:
                    yield f"{package}: broken link {page}#{target}: {question}"
                elif not re.match(r"(?:group|class|struct|namespace)", path.name): # reference pages have every name
                    found += plain(text)
            for name in sorted(set(re.findall(r"--[a-z-]+|\b[A-Za-z]\w{3,}\b", answer))):
                if not re.search(rf"(?<![\w-]){re.escape(name)}(?!\w)", found):
                    yield f"{package}: the answer does not show {name}: {question}"
    if number < FEWEST_QUESTIONS:
        yield f"there are {number} questions only"


def main():
    found = list(complaints(Path(sys.argv[1])))
    print(*found, sep="\n")
    sys.exit(1 if found else 0)


main()
