#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks reference pages: check_reference.py DOC, the folder with PACKAGE/html and PACKAGE/xml.
The manual names functions and classes. The description of each such function outside of classes names all of
its parameters, and states its complexity. Each function and class in an answer to "how do I" links to an
example, or to the section of the answer. Prints each violation, and exits with 1 if there is any."""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import link_reference

HERE = Path(__file__).resolve().parent
PACKAGES = ["Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification"]

# Parameters of functions that name a parameter are described where they are used.
NAMED_PARAMETERS = "named_parameters.h"


def text_of(element):
    return "".join(element.itertext()) if element is not None else ""


def names_in_manual():
    """Names of functions on pages of the manual."""
    found = set()
    for page in HERE.glob("*/*.txt"):
        text = re.sub(r"\\code.*?\\endcode", "", page.read_text(), flags=re.S)
        found |= set(re.findall(r"(\w+)\(\)", text)) | set(re.findall(r"`(?:\w+::)*(\w+)\(", text))
    return found


def functions(doc):
    """Functions outside of classes, by package."""
    for package in PACKAGES:
        for page in sorted((doc / package / "xml").glob("group_*.xml")):
            for member in ElementTree.parse(page).getroot().iter("memberdef"):
                if member.get("kind") == "function":
                    yield member


def described_functions(doc):
    names = names_in_manual()
    for member in functions(doc):
        file = member.find("location").get("file")
        name = text_of(member.find("name"))
        if name not in names or file.endswith(NAMED_PARAMETERS):
            continue
        text = text_of(member.find("briefdescription")) + " " + text_of(member.find("detaileddescription"))
        place = f"{file[file.index('CGAL/'):]}:{member.find('location').get('line')}: {name}()"
        for parameter in map(text_of, (p.find("declname") for p in member.findall("param"))):
            if parameter not in ("", "np") and not re.search(rf"\b{parameter}\b", text):
                yield f"{place}: the description does not name the parameter {parameter}"
        if "Complexity:" not in text:
            yield f"{place}: the description does not state the complexity"


def unlinked(doc):
    """Functions and classes in answers of the first pages whose reference page has no link."""
    documented, linked = set(), set()
    for package in PACKAGES:
        for page in (doc / package / "html").glob("*.html"):
            if not re.match(r"group_|(?:class|struct)[A-Z](?!.*-members)", page.name):
                continue
            text = page.read_text()
            title = re.search(r"<title>[^:]*: (?:[\w:]*::)?(\w+)", text)[1]
            first, *members = text.split('<h2 class="memtitle">')
            titles = [link_reference.TITLE.match('<h2 class="memtitle">' + part) for part in members]
            functions_of_page = [(name[1], part) for name, part in zip(titles, members) if name[2]]
            for name, part in functions_of_page if page.name.startswith("group_") else [(title, first)]:
                documented.add(name)
                if "section examples" in part or "section user" in part:
                    linked.add(name)
    answers = {name for package in PACKAGES for name in link_reference.sections_of(doc, package)}
    return sorted(answers & documented - linked)


def main():
    doc = Path(sys.argv[1])
    found = [*described_functions(doc),
             *(f"{name}: its reference page links to no example or section" for name in unlinked(doc))]
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)


main()
