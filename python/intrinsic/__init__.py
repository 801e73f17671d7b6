# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Intrinsic triangulations, exact geodesics, conformal maps and simplification of surfaces.

A surface is a mesh of trimesh, meshio or pyvista, or a pair of arrays. V (n, 3) has positions, and
F (m, 3) has corners, counted from 0. Points on surfaces are pairs of arrays: faces (k,) and
barycentric coordinates (k, 3), in the order of the corners in F.
"""

from . import errors, shapes
from .distances import (
    DistanceSolver,
    Distances,
    LogMap,
    Path,
    all_pairs,
    distance,
    exp_map,
    geodesic,
    geodesics,
    homology_loops,
    level_set,
    log_map,
    path,
    signed_distance,
    soup_distance,
    transport,
    vertex_point,
)
from .errors import (
    AccuracyWarning,
    ArrayError,
    InputError,
    IntrinsicError,
    LimitError,
    MapError,
    MissingPartError,
    MollificationWarning,
    NegativeCurvatureError,
    NotAManifoldError,
    NumericalError,
    UnderflowError,
)
from .frames import TangentFrames, tangent_frames
from .maps import (
    ConformalMap,
    FlatMap,
    HyperbolicMap,
    MapSubdivision,
    SphereMap,
    Uniformization,
    flatten,
    to_hyperbolic,
    to_sphere,
    uniformize,
)
from .operators import (
    SoupOperators,
    connection_laplacian,
    divergence,
    gradient,
    laplacian,
    mass,
    soup_operators,
)
from .packing import CirclePacking, pack_circles
from .polyhedra import ConvexPolyhedron, convex_polyhedron
from .repairs import Info, Repair, info, repair
from .showing import Page, show
from .simplification import CoarseMesh, Simplification, simplify
from .triangulation import (Certificate, CommonSubdivision, Curves, Refinement, Triangulation,
                            WeightedDelaunay)

__version__ = "0.2.0"

__all__ = [
    "AccuracyWarning",
    "ArrayError",
    "Certificate",
    "CirclePacking",
    "CoarseMesh",
    "CommonSubdivision",
    "ConformalMap",
    "ConvexPolyhedron",
    "Curves",
    "DistanceSolver",
    "Distances",
    "FlatMap",
    "HyperbolicMap",
    "Info",
    "InputError",
    "IntrinsicError",
    "LimitError",
    "LogMap",
    "MapError",
    "MapSubdivision",
    "MissingPartError",
    "MollificationWarning",
    "NegativeCurvatureError",
    "NotAManifoldError",
    "NumericalError",
    "Page",
    "Path",
    "Refinement",
    "Repair",
    "Simplification",
    "SoupOperators",
    "SphereMap",
    "TangentFrames",
    "Triangulation",
    "UnderflowError",
    "Uniformization",
    "WeightedDelaunay",
    "all_pairs",
    "connection_laplacian",
    "convex_polyhedron",
    "distance",
    "divergence",
    "errors",
    "exp_map",
    "flatten",
    "geodesic",
    "geodesics",
    "gradient",
    "homology_loops",
    "info",
    "laplacian",
    "level_set",
    "log_map",
    "mass",
    "pack_circles",
    "path",
    "repair",
    "shapes",
    "show",
    "signed_distance",
    "simplify",
    "soup_distance",
    "soup_operators",
    "tangent_frames",
    "to_hyperbolic",
    "to_sphere",
    "transport",
    "uniformize",
    "vertex_point",
]
