#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Follows the questions of the first page of each manual: check_questions.py DOC, the folder with
PACKAGE/html. Every question has links, each to a section that exists. These sections name every function,
class and option of the answer. The first page of the first package links to all other tables, so each answer
is two clicks from it. Some first page links to every page, and all links of pages lead to something.
Prints each violation, and exits with 1 if there is any."""

import html
import re
import sys
from pathlib import Path

# First pages and headings of their tables.
TABLES = [("Intrinsic_triangulations", "it_tasks"), ("Discrete_conformal_maps", "dcm_tasks"),
          ("Intrinsic_simplification", "is_tasks")]
FEWEST_QUESTIONS = 100


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


def links_of(page):
    """Pairs of the file and the anchor of each link of a page, from its own text without menus."""
    text = page.read_text()
    text = text[text.find('<div class="contents">'):]
    for target, anchor in re.findall(r'href="([^"#:]*)(?:#([^"]*))?"', text):
        yield (page.parent / target).resolve() if target else page, anchor


def unreachable(doc):
    """Complaints about tables and pages without a link from a first page, and about links that lead nowhere."""
    first_pages = [doc / package / "html/index.html" for package, _ in TABLES]
    clicks = {link for page in first_pages for link in links_of(page)}
    for (package, anchor), page in zip(TABLES[1:], first_pages[1:]):
        if (page.resolve(), anchor) not in set(links_of(first_pages[0])):
            yield f"{package}: the first page does not link to its questions"
    pages = [page for package, _ in TABLES for page in sorted((doc / package / "html").glob("*.html"))
             if re.match(r"Chapter_|(?:it|dcm|is)_page_", page.name)]
    for page in [*first_pages, *pages]:
        if page in pages and page.resolve() not in {target for target, _ in clicks}:
            yield f"{page.name}: no first page links to it"
        for target, anchor in links_of(page):
            if not target.exists() or anchor and not re.search(f'(?:id|name)="{re.escape(anchor)}"', target.read_text()):
                yield f"{page.name}: broken link to {target.name}#{anchor}"


def main():
    doc = Path(sys.argv[1])
    found = [*complaints(doc), *unreachable(doc)]
    print(*found, sep="\n")
    sys.exit(1 if found else 0)


main()
