// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "help_texts.h"

namespace Help {

const char* const examples =
  R"(Examples:
  intrinsic info bunny.obj
  intrinsic view bunny.obj scan.stl -o meshes.html
  intrinsic delaunay bunny.obj -o subdivision.ply --stats bunny.json --view bunny.html
  intrinsic delaunay scan.stl --repair -o - --format obj | gzip > scan.obj.gz
  intrinsic refine bunny.obj -o refined.ply --min-angle 30
  intrinsic distance bunny.obj --source 17 -o distance.vtp
  intrinsic path bunny.obj --from 17 --to 99 -o path.obj
  intrinsic operators bunny.obj --prefix bunny
  intrinsic flatten bunny.obj -o flat.obj
  intrinsic hyperbolic pretzel.obj -o disk.obj --svg tiling.svg
  intrinsic sphere bunny.obj -o sphere.ply
  intrinsic simplify bunny.obj -o coarse.ply --ratio 0.02

Colors, normals, texture coordinates and numbers at the vertices of a mesh, and the groups and
materials of faces of .obj files, are carried to the meshes that are written, as far as their format
has them.

Exit code: 0 done, 1 the computation failed, 2 the input or the call was wrong.)";

const char* const view =
  R"(The page is one file that opens in any browser with WebGL 2, without a network. It shows the
meshes beside each other, turned alike, with what is wrong in red. Clicking on a point shows where
it is. Keys are explained in the page.

All other commands write such a page with --view FILE.html: the surface with the edges of its
triangulations, colored by scale factors, distances or curvature, by functions of the input, or by
faces; its image in the plane, on the sphere or in the Poincare disk; with a checkerboard, drawn by
projective or linear interpolation; histograms of angles before and after, and the statistics. Pages
of large meshes draw intrinsic edges without the common subdivision; --direct asks for this.

Example:
  intrinsic view bunny.obj scan.stl -o meshes.html)";

const char* const refine =
  R"(The result is Delaunay and is written with exit code 0 however refinement has ended. The
status, in the statistics and in the last line on standard error, says how:
  bounds_met              every face obeys the bounds
  bounds_met_but_excused  those that do not are at vertices too narrow for the angle
  insertion_limit         --max-insertions was too little; some faces are left. Lower --min-angle,
                          or allow more if the surface is worth it
  no_room                 floating point numbers are too coarse for the faces that are left
On closed meshes without narrow vertices and sharp edges to keep, refinement to at most 30
degrees is proven to end, in exact arithmetic; with boundary this is an open question, and 25
degrees have worked on all ordinary meshes tried. Greater angles can make it insert vertices without
end: hence the smaller default of --max-insertions. Where rounding leaves doubts, refinement goes on
or starts again with exact decisions; the last line and "exact_decisions" in the statistics say so.
With --exact the decisions are exact from the beginning, and the result is certified: "certified" in
the statistics says whether it is geodesic and exactly Delaunay, "ties" how many edges could be
flipped as well, "decisions" how the certificate was reached.

Vertices of the output have a property "kind" in .ply and .vtp: 0 input vertex, 1 crossing of an
input edge with an intrinsic edge, 2 inserted vertex.

With --simplicial the output is an ordinary mesh, for other programs: its vertices lie on the surface,
its edges are straight in space, and their property "length" is that on the surface. Seams of a
texture stay edges, unless the output is .off.

Examples:
  intrinsic refine scan.ply -o mesh.ply --simplicial
  intrinsic refine scan.ply -o refined.vtp --min-angle 25 --stats refined.json)";

const char* const distance =
  R"(Distances are approximate: on evenly spread vertices by some two percent on average, on
coarse or uneven ones by more. With --exact-distance they are the lengths of shortest paths. The
distance of a vertex that no source can reach is -1.

A curve is what path writes, or polylines of another program: elements l of .obj, edges of .ply,
Lines of .vtp with ascii numbers, the points of .xyz. Its points are moved to the surface and joined
by shortest paths. With --signed,
distances are negative on its left, as inside a loop that runs counterclockwise; gaps and single
pieces of the wrong direction are bridged.

Triangles need not be a surface: edges of three and more faces, vertices of several fans and any
orientation are worked on through their tufted cover. With --neighbors points without faces are
triangulated with their neighbors.

Example:
  intrinsic distance bunny.obj --source 17 --source 99 -o distance.ply
  intrinsic distance bunny.obj --curve loop.obj --signed -o distance.vtp)";

const char* const path =
  R"(The path is the shortest of all, to rounding. With --flips it is a geodesic instead: the shortest
path along edges from vertex to vertex, through all --via, is pulled tight where it is, and so is a
loop with --loop. The status, in the statistics and in the last line on standard error:
  shortest             no path is shorter
  geodesic             nowhere can it be shortened by small changes
  blocked              it crosses itself, and is geodesic elsewhere
  straightest          it has the length that was asked for
  stopped_at_boundary  it met the boundary before
The statistics have all its places on the mesh, and the edges of the intrinsic triangulation after
flips, which --save writes.

Examples:
  intrinsic path bunny.obj --from 17 --to 1000:0.2,0.3,0.5 -o path.vtp
  intrinsic path bunny.obj --from 17 --via 99 --via 612 --loop -o loop.obj --stats loop.json
  intrinsic path bunny.obj --from 0.1,0.2,0 --straightest 30 0.25 -o ray.ply)";

const char* const transfer =
  R"(Of --points each line of the output has two places, face:a,b,c on the mesh and on the intrinsic
triangulation; with --back such lines are read. Of --data the output has a value for each vertex of
the other triangulation, in lines "index value": of the linear function that is closest in the mean
square, with the same integral. Faces and vertices of the intrinsic triangulation are those that
--save writes. Statistics say how far points or values are off after going there and back.

Examples:
  intrinsic transfer bunny.obj --points points.txt -o places.txt
  intrinsic transfer bunny.obj --data heights.txt --min-angle 25 -o refined.txt --stats s.json)";

const char* const operators =
  R"(Files, with v vertices and f faces of the intrinsic triangulation:
  PREFIX_laplacian.mtx             cotan Laplacian, positive semidefinite (v x v, symmetric)
  PREFIX_mass.mtx                  consistent mass (v x v, symmetric)
  PREFIX_lumped_mass.mtx           lumped mass (v x v, diagonal)
  PREFIX_connection_laplacian.mtx  connection Laplacian (v x v, complex Hermitian)
  PREFIX_gradient.mtx              values at vertices to vectors on faces (2f x v)
  PREFIX_divergence.mtx            vectors on faces to integrals at vertices (v x 2f)
Rows and columns of vertices are in the order of the input, inserted vertices after them. Those of
faces, two for each, and the frames of tangent vectors are those of the triangulation that --save
writes.

Triangles need not be a surface, and with --neighbors there may be points alone. Then f counts faces
of the tufted cover, which has two for each triangle, and there is one file more:
  PREFIX_cover_vertices.mtx        values at vertices to those at vertices of the cover (c x v)
The connection Laplacian is c x c.

Example:
  intrinsic operators bunny.obj --prefix bunny --save bunny.txt)";

const char* const flatten =
  R"(The map is discretely conformal: angles are kept as well as a triangle mesh can. Without
--boundary, areas on the boundary are kept too. A surface that has no boundary is cut through its
cones.

Boundaries, after --boundary; write MESH before it:
  free            vertices on the boundary are not scaled (the default)
  straight        all exterior angles are zero
  scale FILE      logarithms of their scale factors are prescribed
  curvature FILE  their exterior angles are prescribed
  rectangle       of each component: four corners; those are as far apart along the boundary as
                  they can be while being about as sharp as its four sharpest vertices
  disk            of each component: a circle
Rectangles and disks are for components with one boundary; they have no cones unless they are
asked for.

A FILE has lines "index value": an index of a vertex, from 0, and radians or a logarithm. What
follows a # is a comment. Vertices that are not listed have curvature zero: inside they are flat,
on the boundary straight. In the file of --cones the values are angle defects, 2 pi less the sum
of angles; an empty one makes a torus flat. All curvatures must add up to 2 pi times the Euler
characteristic, unless scale factors are prescribed somewhere.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the
flat triangulation. At the corners of its faces stand u and v, which are lengths in the plane, not
limited to one. Charts of components stand beside each other. With --linear (the default, which
every program reads) they are taken as linear on each face; the map itself is projective there,
and exact with --homogeneous: three numbers u w, v w, w, linear on faces, to be divided after
interpolation.
  .obj  "vt u v", or "vt uw vw w"
  .ply  a list "texcoord" (or "homogeneous_texcoord") of each face, with all numbers of its
        corners
  .vtp  a property with that name of points, which are repeated along seams
.ply and .vtp have for each vertex the input vertex (-1 if it is none), whether it is a cone and
its logarithmic scale factor; of faces (and in .ply of edges) of which input, intrinsic and flat
face or edge they are a part. Edges with is_seam 1 are cut open.

With --exact, the flips to the intrinsic Delaunay triangulation are decided exactly, on the surface
of the edge lengths, and the map is certified: "certified" in the statistics says whether this
triangulation is Delaunay, the flat one is ideal Delaunay with the scale factors as they are, and
all crossings are in order, without a tolerance. "greatest_excess", "exchanged_crossings" and
"undecided_crossings" say what stands against it: ties of the surface are decided by rounding.

Solvers:
  newton  Newton's method, to the last digits
  ceres   L-BFGS of the Ceres Solver, as precise: fewer factorizations, more evaluations
  cetm    Newton's method in the triangulation of the mesh, without any flip, for comparison.
          There the scale factors depend on the triangulation and often do not exist; the error
          says which condition is violated: triangle_inequality or no_minimum.

The file of --matrix has a sparse matrix with one row for each vertex of the output, in the order
of .obj and .ply (.vtp repeats vertices along seams), and one column for each vertex of the mesh.
Its product with values at the vertices of the mesh (positions, colours, logarithmic scale
factors) is the values at the vertices of the output, linear on the faces of the mesh. Each row
has one to three weights, sum one. Rows of vertices of the mesh come first, in their order, so the
matrix starts with the identity.

If the minimization does not converge, or there is no map, nothing is written.

Examples:
  intrinsic flatten bunny.obj -o flat.obj --cones greedy --max-log-scale 3
  intrinsic flatten face.ply -o flat.ply --boundary disk --stats flat.json)";

const char* const hyperbolic =
  R"(Every component must have genus two or more, or boundaries, or cones enough; boundaries become
geodesics, and what is laid out is the double of the surface, as far as it belongs to the mesh.

The output is as that of `intrinsic flatten`, with positions in the Poincare disk. With
--homogeneous they are x t, y t, t, in Klein's disk, where the map is exact.

Statistics: the area, which is 4 pi (genus - 1); for each component its genus and the motions z ->
(a z + b) / (conj(b) z + conj(a)) that glue the sides of its domain, as real and imaginary parts
of a and b; a relation, the order in which their product is the identity (from 1, negative for
inverse ones), and its error. max_gluing_error is that of the corners of the domain, radius
how far from its middle it reaches: in double precision, positions at a distance d are good for
1e-16 exp(d).

Example:
  intrinsic hyperbolic pretzel.obj -o disk.obj --svg tiling.svg --tiles 4 --stats pretzel.json)";

const char* const uniformize =
  R"(The mesh must be connected. By its topology it becomes
  a sphere      round, as with `intrinsic sphere`
  a disk        a hemisphere, as with `intrinsic sphere`; its texture is the image in the unit disk
  a torus       flat, as with `intrinsic flatten --cones none`
  a cylinder    with two boundaries and no handles: flat, with straight boundaries
  hyperbolic    with more handles or boundaries, as with `intrinsic hyperbolic`

Statistics are those of these commands, and "modulus": of a torus the quotient tau of the
generators of its lattice in the fundamental domain of the modular group, as real and imaginary
part; of a cylinder the height over the circumference, as imaginary part.

Example:
  intrinsic uniformize torus.obj -o flat.obj --stats torus.json)";

const char* const sphere =
  R"(The mesh must be connected and a sphere or a disk. The image is a convex polyhedron with
vertices on the unit sphere, discretely conformal to the mesh, that has its center of mass (with
areas of the mesh) in the center; or one half of such a polyhedron, with the boundary on the
equator. Convexity is decided exactly.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the
polyhedron, projected to the sphere. .ply and .vtp have for each vertex the input vertex (-1 if it
is none) and its logarithmic scale factor, its place in the mesh (input_x, input_y, input_z) and
homogeneous coordinates on the polyhedron (homogeneous_x, _y, _z, _w), which are linear on faces;
of faces (and in .ply of edges) of which input, intrinsic and sphere face or edge they are a part.
A disk has its image in the unit disk as texture coordinates.

Long limbs have small images. Where the digits of the output are too few for them, triangles lose
their convexity or are flipped: lost_in_output in the statistics says how many. --precise writes
the positions of the input vertices with 36 digits.

Vertices without faces stay, at (0, 0, 1) or beside a disk (1, 0, 0), with homogeneous coordinates
zero. If the image is not convex, nothing is written.

Example:
  intrinsic sphere cow.off -o sphere.ply --stats sphere.json --precise sphere.txt)";

const char* const simplify =
  R"(Vertices are removed one after the other, the one of least cost first. Nothing moves in space:
what is left is an intrinsic triangulation, Delaunay, of a surface close to the mesh in its
distances. The cost of a vertex is a length: how far its curvature, area, or both times their
weights, will have been moved, times the part of the whole that this is. With a weight of color
(in .ply, .off and .obj) or any other numbers at the vertices (properties in .ply, by their names) their
Laplacian is moved too, so that more vertices stay where their gradients change. --error ends with
the last vertex whose cost is not above. Where vertices cannot be removed any more, simplification
ends early, with exit code 0 and the status "nothing_removable" in the statistics. Vertices
without faces stay; --vertices and --ratio do not count them.

With --min-angle, vertices are inserted into the coarse triangulation in the end until its angles
obey the bound, or faces are at vertices too narrow for that, as by `intrinsic refine`. All output
is about the refined coarse triangulation.

With --close-loops and --pinch-handles the topology of the mesh becomes simpler before: boundary
loops up to a length are closed, and handles are cut along closed curves of edges up to a length,
the shortest first, and closed on both sides. What closes a loop is a disk of triangles around a
new vertex. The rest of the mesh stays as it is. Faces of the disks have -1 as "input_face"; in the
output their vertex is in the middle of the others, to be seen, but lengths are those of the disk.
The lengths are in the units of the mesh.

With --exact, refinement before and the intrinsic Delaunay triangulation from which vertices are
removed are decided exactly and certified, as by `intrinsic delaunay --exact`; removals change the surface,
by rounded numbers, and are not.

The output is the common subdivision of the mesh and the coarse triangulation. In .ply and .vtp
faces have the properties "coarse_face" and "input_face", and a color by which adjacent coarse
faces differ; in .ply edges have "coarse_edge" and "input_edge", or -1, and .vtp has the coarse
edges as poly-lines. Vertices have the properties "coarse_vertex", or -1, and "kind": 0 input
vertex, 1 crossing of a coarse edge with an edge, 2 inserted vertex, 3 bend of a coarse edge
inside a face. With --refine more edges lead to the inserted vertices, within the
faces of the mesh.

P of --prolongation has a row for each vertex of the mesh and a column for each coarse vertex. Its
rows are barycentric coordinates: not negative, with sum 1. With L levels there are L matrices,
P_1.mtx to P_L.mtx, each from one level to the one before; the vertices of the levels are those of
the mesh that are left, in their order. Vertices inserted by --refine follow those of the mesh;
they can be coarse vertices, but have no rows in the first matrix. Those of --min-angle are the
last of the coarse vertices.

--save writes all levels and the operations between them; with --refine, the mesh with the
inserted vertices before.

Example:
  intrinsic simplify bunny.obj -o coarse.vtp --vertices 500 --weight area=0.5)"
  " --prolongation P.mtx";

} // namespace Help
