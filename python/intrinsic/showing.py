# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pages that show surfaces in a browser or a notebook."""

from __future__ import annotations

import html
import os
import tempfile
import webbrowser
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from . import _core
from ._arrays import floats
from ._meshes import arrays
from .errors import MissingPartError


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
    MissingPartError
        If the package was built without nlohmann_json, or without three.js, which the build
        fetches from the network.
    """
    points, faces = arrays(V, F)
    values = {name: floats(f, (len(points),), name) for name, f in functions.items()}
    if not _core.has_pages:
        raise MissingPartError("pages need nlohmann_json and three.js, which were not there when "
                               "this package was built")
    page = Page(_core.page(points, faces, list(values.items())), height)
    if open:
        page.open()
    return page
