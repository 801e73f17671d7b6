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
from ._arrays import Floats, count, flag, floats_or_infinity
from ._meshes import arrays
from .errors import InputError, MissingPartError
from .maps import ConformalMap, HyperbolicMap, SphereMap
from .triangulation import Triangulation


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


def _named(functions: dict[str, ArrayLike], n: int) -> list[tuple[str, Floats]]:
    return [(name, floats_or_infinity(f, (n,), name)) for name, f in functions.items()]


def _page_of_map(shown: ConformalMap, functions: dict[str, ArrayLike]) -> str:
    pieces = shown.subdivision
    if pieces.V is None:
        raise InputError("the surface has no positions; give V instead of lengths")
    values = [("log_scale", shown.log_scale), *_named(functions, len(shown.log_scale))]
    kind = ("sphere" if isinstance(shown, SphereMap)
            else "disk" if isinstance(shown, HyperbolicMap) else "plane")
    return _core.page_of_map(pieces.V, pieces.starts, pieces.corners, pieces.corner_image,
                             pieces.image, pieces.homogeneous, kind,
                             [(name, pieces.from_input @ f) for name, f in values])


def show(
    V: Any, F: ArrayLike | None = None, *, open: bool = True, height: int = 600,
    direct: bool = False, **functions: ArrayLike,
) -> Page:
    """Show a mesh, an intrinsic triangulation or a map, and functions at vertices, in a browser.

    Parameters
    ----------
    V : (n, 3) array of floats, a mesh object, a Triangulation, or a map
        Positions, or an object with a surface and positions. A Triangulation is drawn with edges of
        both triangulations, a map with its image.
    F : (m, 3) array of integers
        The corners of each face, if V are positions.
    open : bool
        Whether a browser is opened. A notebook shows the result without.
    height : int
        The height of the frame in a notebook, in pixels.
    direct : bool
        Whether the page finds the intrinsic edges of a Triangulation while it draws, without the
        common subdivision. It does this beyond 200,000 polygons, but not for mollified lengths.
    **functions : (n,) arrays of floats
        Values at vertices, by name, among which the page lets you choose. They may be infinite, as
        some distances. Functions on a Triangulation may have values at its inserted vertices too.

    Returns
    -------
    Page

    Raises
    ------
    InputError
        If the surface has no positions.
    MissingPartError
        If the package was built without nlohmann_json, or without three.js, which the build
        fetches from the network.
    """
    if not _core.has_pages:
        raise MissingPartError("pages need nlohmann_json and three.js, and this package was built "
                               "without them")
    is_direct, is_opened, pixels = flag(direct, "direct"), flag(open, "open"), count(height, "height", 1)
    if isinstance(V, Triangulation):
        text = V._page(functions, is_direct)
    elif isinstance(V, ConformalMap):
        text = _page_of_map(V, functions)
    else:
        points, faces = arrays(V, F)
        text = _core.page(points, faces, _named(functions, len(points)))
    page = Page(text, pixels)
    if is_opened:
        page.open()
    return page
