# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pages that show surfaces in a browser or a notebook."""

from __future__ import annotations

import html
import os
import shutil
import subprocess
import tempfile
import webbrowser
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Floats, Integers, floats
from ._meshes import arrays
from .errors import ArrayError, IntrinsicError, MissingProgramError


class Page:
    """A page in HTML that needs no network. A notebook shows it in a frame."""

    def __init__(self, text: str, height: int = 600) -> None:
        self.html = text
        self.height = height

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the page."""
        Path(path).write_text(self.html, encoding="utf-8")

    def open(self) -> None:
        """Open the page in a browser, from a file that stays in the directory for temporary
        files."""
        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as f:
            f.write(self.html)
        webbrowser.open(Path(f.name).as_uri())

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.html)}" width="100%" height="{self.height}" '
                'style="border: 0"></iframe>')

    def __repr__(self) -> str:
        return f"<Page of {len(self.html)} characters>"


def program() -> str:
    """Return the path of the program `intrinsic`, from the environment variable
    INTRINSIC_PROGRAM, or in the PATH."""
    path = os.environ.get("INTRINSIC_PROGRAM") or shutil.which("intrinsic")
    if path is None or not os.access(path, os.X_OK):
        raise MissingProgramError("the program intrinsic is not found, which writes pages; install "
                                  "it, or set INTRINSIC_PROGRAM to its path")
    return path


def show(
    V: Any, F: ArrayLike | None = None, *, open: bool = True, height: int = 600,
    **functions: ArrayLike,
) -> Page:
    """Show a mesh, and functions at its vertices, in a browser.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object
        Positions.
    F : (m, 3) array of integers
        The corners of each face.
    open : bool
        Whether a browser is opened. A notebook shows the result without.
    height : int
        The height of the frame in a notebook, in pixels.
    **functions : (n,) arrays of floats
        Values at vertices, by name, among which the page lets you choose.

    Returns
    -------
    Page

    Raises
    ------
    MissingProgramError
        If the program `intrinsic`, which writes the page, is not found.
    """
    points, faces = arrays(V, F)
    values = {name: floats(f, (len(points),), name) for name, f in functions.items()}
    if any(name in ("x", "y", "z") for name in values):
        raise ArrayError("functions must have other names than x, y and z")
    with tempfile.TemporaryDirectory() as folder:
        mesh, written = Path(folder, "mesh.ply"), Path(folder, "page.html")
        mesh.write_bytes(_ply(points, faces, values))
        done = subprocess.run([program(), "view", str(mesh), "-o", str(written)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise IntrinsicError(f"the page cannot be written: {done.stderr.strip()}")
        page = Page(written.read_text(encoding="utf-8"), height)
    if open:
        page.open()
    return page


def _ply(points: Floats, faces: Integers, values: dict[str, Floats]) -> bytes:
    names = ["x", "y", "z", *values]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}",
              *(f"property double {name}" for name in names), f"element face {len(faces)}",
              "property list uchar int vertex_indices", "end_header", ""]
    rows = np.empty(len(faces), dtype=[("n", "u1"), ("corners", "<i4", 3)])
    rows["n"], rows["corners"] = 3, faces
    table = np.column_stack([points, *values.values()]).astype("<f8")
    return "\n".join(header).encode("ascii") + table.tobytes() + rows.tobytes()
