# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tests that scripts/check_figures.py finds figures outside tables, tables without a page or a
benchmark, and drawings of one size, and nothing else; and that scripts/make_tables.py reads what benchmarks print and keeps old
tables if they fail: check_figures.py SCRIPTS."""

import contextlib
import io
import shutil
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, sys.argv[1])
import check_figures
import make_tables

SENTENCES = {
    "It takes 0.26 seconds.": True, "It takes 30 &micro;s.": True, "about two seconds": True, "in 5.9 GB": True,
    "An error of 1.1 % remains.": True, "by 0.9 percent": True, "a third of a second": True,
    "1.8 times as long": True, "It is 3 times faster.": True, "twice the time": True, "a factor of 1.15": True,
    "Rounding of 1e-10 and 32 digits.": False, "It maps all 3 sides.": False, "\\f$5 \\%\\f$ is a formula": False,
    "Angles of 25 degrees, with 2,000 vertices.": False, "a third of the area": False,
    "Flips take a third to a half less time.": True, "Less time is needed.": False,
}
TYPED = {"| a | b |\n| --- | ---: |\n| x | 1 |\n": True, "| a | b |\n| --- | --- |\n| x | y |\n": False,
         "| part | bytes |\n| --- | ---: |\n| x | 1 |\n": False}


def expect(is_true, what):
    if not is_true:
        sys.exit(what)


def is_found(check, text):
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "Benchmarks.txt"
        path.write_text(f"/*!\n{text}\n*/\n")
        return any(check(path))


def complaints(root):
    """Returns what the script says about a copy of the manual."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        sys.argv[1:] = [str(root)]
        check_figures.main()
    return out.getvalue()


def check_manual():
    with tempfile.TemporaryDirectory() as scratch:
        root, table = Path(scratch), "doc/Discrete_conformal_maps/tables/cones.md"
        shutil.copytree(make_tables.ROOT / "doc", root / "doc")
        for name in ["README.md", "CHANGES.md"]:
            shutil.copy(make_tables.ROOT / name, root)
        expect(complaints(root) == "", "complaints about the manual")
        page = root / "doc/Discrete_conformal_maps/Benchmarks.txt"
        page.write_text(page.read_text().replace("\\include{doc} cones.md\n", ""))
        expect(f"{table}: no page includes it" in complaints(root), "a table without a page")
        page.write_text(page.read_text() + "\\include{doc} other.md\n")
        expect("other.md does not exist" in complaints(root), "a page without a table")
        (page.parent / "tables/other.md").write_text("| a |\n")
        expect("other.md: scripts/make_tables.py does not" in complaints(root), "a table without a benchmark")
        summary = root / "doc/Intrinsic_triangulations/tables/summary.md"
        summary.write_text(summary.read_text().replace(" ms |", "1 ms |"))
        expect("summary.md: the summary differs" in complaints(root), "another summary")
        changes = root / "CHANGES.md"
        changes.write_text(changes.read_text() + "- Distances are three times faster.\n")
        expect("CHANGES.md" in complaints(root), "a figure in the list of changes")
        drawing = root / "doc/Intrinsic_triangulations/fig/flip.svg"
        drawing.write_text(drawing.read_text().replace("viewBox", "box"))
        expect("flip.svg: a drawing without a viewBox" in complaints(root), "a drawing of one size")


def check_tables():
    printed = "Factors\n\n| a | b |\n|---|---:|\n| x  |  1 |\nnote\n| b |\n| :-: |\n| all 3 | 4 |\n"
    tables = make_tables.tables_in(printed)
    expect(tables == [["| a | b |", "| --- | ---: |", "| x | 1 |"], ["| b |", "| :-: |", "| all 3 | 4 |"]], tables)
    expect(make_tables.chosen_rows(tables[1], ("all",))[2:] == ["| all 3 | 4 |"], "a row that is chosen")
    expect(make_tables.chosen_rows(tables[1], ("x",))[2:] == [], "a row that is not chosen")


def check_replacement():
    make_tables.build_target = lambda build, target: target == "z"
    make_tables.machine = lambda build: "a machine"
    with tempfile.TemporaryDirectory() as scratch:
        make_tables.ROOT = Path(scratch)
        table = make_tables.path_of("Intrinsic_triangulations/x")
        table.parent.parent.mkdir(parents=True)
        run = lambda command: make_tables.make(make_tables.Run("Intrinsic_triangulations/x", command, "y", target="z"),
                                               Path(scratch))
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            first = run("echo '| a |'; echo '| --- |'; echo '| 1 |'")
            text = table.read_text()
            second = run("echo '| a |'; echo '| --- |'; echo '| 2 |'; false")
            third = run("echo none")
            other = make_tables.make(make_tables.Run("Intrinsic_triangulations/x", "true", "y", target="missing"),
                                     Path(scratch))
        expect((first, second, third, other) == (True, False, False, False), "which benchmarks succeed")
        expect(text.startswith("| a |\n| --- |\n| 1 |\n\nMeasured by `echo"), "a new table")
        expect(text.endswith(" on y; a machine.\n") and table.read_text() == text, "an old table")
        expect([path.name for path in table.parent.iterdir()] == ["x.md"], "a file beside the table")


for sentence, is_figure in SENTENCES.items():
    expect(is_found(check_figures.figures_in_sentences, sentence) == is_figure, sentence)
for text, is_figure in TYPED.items():
    expect(is_found(check_figures.typed_tables, text) == is_figure, text)
check_manual()
check_tables()
check_replacement()
