#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Adds links to reference pages: link_reference.py DOC, the folder with PACKAGE/html.
Each function and class gets links to the sections that answer questions with its name, on the first pages.
Doxygen links functions to examples that call them, except templates that it cannot resolve, and classes.
Each function and class whose name an example contains gets the missing links."""

import html
import re
import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
PACKAGES = ["Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification"]
MOST_EXAMPLES = 6
TITLE = re.compile(r'<h2 class="memtitle">(?:<span class="permalink">.*?</span>)?(?:\w+::)*(\w+)(\(\))?')


def folder_of(package, other):
    return "" if other == package else f"../../{other}/html/"


def examples_of(package):
    """Pairs of addresses and titles of examples, by the names in them. Examples of the package come first."""
    found = {}
    for source in sorted(EXAMPLES.glob("*/*.cpp"), key=lambda path: (path.parent.name != package, path)):
        other = source.parent.name
        page = f"{folder_of(package, other)}{other}_2{source.stem}_8cpp-example.html"
        text = re.sub(r"//.*|#include.*", "", source.read_text())
        # Functions are called, and types begin with a capital letter.
        for name in set(re.findall(r"\b(?:[a-z]\w*(?=[(<])|[A-Z]\w*)", text)):
            found.setdefault(name, []).append((page, f"{other}/{source.name}"))
    return found


def sections_of(doc, package):
    """Pairs of addresses and titles of sections that answer questions, by the names in the answers."""
    found = {}
    for other in PACKAGES:
        index = (doc / other / "html/index.html").read_text()
        for row in re.findall(r"<tr.*?</tr>", index, re.S):
            cells = re.findall(r"<td.*?</td>", row, re.S)
            if len(cells) < 3:
                continue
            answer = html.unescape(re.sub(r"<[^>]*>", " ", cells[1]))
            for name in set(re.findall(r"\b[a-z]\w*(?=\()|\b[A-Z]\w*", answer)):
                for address, title in re.findall(r'<a class="el" href="([^"]*)">(.*?)</a>', cells[-1]):
                    link = (folder_of(package, other) + address if not address.startswith("..") else address, title)
                    if link not in found.setdefault(name, []):
                        found[name].append(link)
    return found


def definition_list(kind, heading, links):
    items = ", ".join(f'<a class="el" href="{address}">{title}</a>' for address, title in links)
    return f'<dl class="section {kind}"><dt>{heading}</dt><dd>{items}.</dd></dl>\n' if links else ""


class Linker:
    def __init__(self, doc, package):
        self.examples = examples_of(package)
        self.sections = sections_of(doc, package)

    def links(self, name, text):
        result = definition_list("user", "User manual", self.sections.get(name, []))
        if "section examples" not in text:
            result += definition_list("examples", "Examples", self.examples.get(name, [])[:MOST_EXAMPLES])
        return result

    def with_member_links(self, text):
        """Adds links at the end of the description of each function."""
        parts = re.split(r'(?=<h2 class="memtitle">)', text)
        for i, part in enumerate(parts[1:], 1):
            title, end = TITLE.match(part), part.rfind("\n</div>\n</div>")
            if title and title[2] and end > 0:
                parts[i] = part[:end] + "\n" + self.links(title[1], part) + part[end:]
        return "".join(parts)

    def with_class_links(self, text):
        """Adds links at the end of the detailed description of a class."""
        title, start = re.search(r"<title>[^:]*: (?:[\w:]*::)?(\w+)", text), text.find('<div class="textblock">')
        if not title or start < 0:
            return text
        following = re.compile(r'<h2 class="groupheader">|<hr/>|<!-- contents -->').search(text, start)
        end = text.rfind("</div>", start, following.start())
        return text[:end] + self.links(title[1], text[start:end]) + text[end:]


def main():
    doc = Path(sys.argv[1])
    for package in PACKAGES:
        linker = Linker(doc, package)
        for page in sorted((doc / package / "html").glob("*.html")):
            if page.name.startswith("group__"):
                page.write_text(linker.with_member_links(page.read_text()))
            elif re.match(r"(?:class|struct)[A-Z](?!.*-members)", page.name):
                page.write_text(linker.with_class_links(page.read_text()))


if __name__ == "__main__":
    main()
