// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/help_texts.h"

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

Colors, normals, texture coordinates and functions at the vertices of a mesh, and the groups and
materials of faces of .obj files, are carried to the meshes that are written, if their format
supports them.

Edges must be between 2^-127 and 2^127 (5.9e-39 and 1.7e38) long.

Exit code: 0 done, 1 the computation failed, 2 the input or the call was wrong, 3 a map that failed
was written with --keep-going.)";

const char* const view =
  R"(The page is one file that opens in any browser with WebGL 2, without a network. It shows the
meshes side by side, turned together, with their defects in red. Clicking on a point shows its
place. The page explains the keys.

All other commands write such a page with --view FILE.html: the surface with the edges of its
triangulations, colored by scale factors, distances or curvature, by functions of the input, or
by faces; its image in the plane, on the sphere or in the Poincare disk; with a checkerboard, by
projective or linear interpolation; histograms of angles, and the statistics. Pages of large
meshes draw intrinsic edges without the common subdivision, as with --direct.

Example:
  intrinsic view bunny.obj scan.stl -o meshes.html)";

const char* const refine =
  R"(The result is Delaunay and is written with exit code 0 whatever the status, which is in the
statistics and in the last line on standard error:
  bounds_met              every face obeys the bounds
  bounds_met_but_excused  faces that violate the bound on angles are excused by narrow vertices
  insertion_limit         --max-insertions was reached; some faces violate the bounds. Lower
                          --min-angle, or raise --max-insertions
  no_room                 floating point coordinates are too coarse for the faces that are left
On closed meshes without narrow vertices and constrained edges, refinement to at most 30 degrees
is proven to terminate, in exact arithmetic; with boundary this is an open question, but 25
degrees were reached on all meshes of CGAL. With greater angles it need not terminate: hence the
smaller default of --max-insertions. If rounded lengths do not suffice, refinement starts anew
with exact decisions; the last line and "exact_decisions" in the statistics report this. With
--exact the decisions are exact from the beginning, and the result is certified: the statistics
have "certified", whether it is geodesic and exactly Delaunay, "ties", the number of edges whose
flip is Delaunay too, "undecided", the number of edges and vertices for which a decision involves
more than twelve independent square roots, and "decisions", the number of decisions at each stage.
A result that is not certified is written, too; the last line says so.

Vertices of the output have a property "kind" in .ply and .vtp: 0 input vertex, 1 crossing of an
input edge with an intrinsic edge, 2 inserted vertex.

With --simplicial the output is an ordinary mesh, for other programs: its vertices lie on the
surface, its edges are straight in space, and their property "length" is the length on the
surface. Seams of a texture stay edges, unless the output is .off.

Examples:
  intrinsic refine scan.ply -o mesh.ply --simplicial
  intrinsic refine scan.ply -o refined.vtp --min-angle 25 --stats refined.json)";

const char* const distance =
  R"(Distances are exact by default (lengths of shortest paths, up to rounding), as long as that is
expected to take less than two seconds: up to 31,000 vertices with one source, more with several.
Beyond that, for triangles that are not a surface, with --signed and with --method heat, they are
approximate: heat has an error of about two percent on average on evenly distributed vertices, and
more on coarse or uneven ones. The last line and the statistics name the method; with heat they have
an estimate of the error, from exact distances to the nearest vertices. A warning says where a tenth
of these are wrong by more than 10 %. The distance of a vertex that no source can reach is -1.

A file of --curve is written by path, or has polylines of another program: elements l of .obj,
edges of .ply, Lines of .vtp with ascii numbers, the points of .xyz. Its points are moved to the
surface and joined by shortest paths. With --signed, distances are negative on the left of the
curve, as inside a loop that runs counterclockwise; gaps and single segments of the wrong
direction are bridged.

The triangles need not form a surface: a soup with edges of three or more faces, vertices of
several fans and any orientation has a tufted cover. With --neighbors, points without faces are
triangulated with their neighbors.

Example:
  intrinsic distance bunny.obj --source 17 --source 99 -o distance.ply
  intrinsic distance bunny.obj --curve loop.obj --signed -o distance.vtp)";

const char* const path =
  R"(The path is shortest, up to rounding. With --flips it is a geodesic: the shortest path along
edges from vertex to vertex, through all --via, is shortened in its homotopy class, and with
--loop a loop. With --homology there are as many loops as are needed for every closed curve to be
homologous to a combination of them. The status, in the statistics and in the last line on standard
error:
  shortest             no path is shorter
  geodesic             no small change shortens it
  blocked              it crosses itself, and is geodesic elsewhere
  straightest          it has the requested length
  stopped_at_boundary  it ends at the boundary
The statistics have all its places on the mesh and, after flips, its edges in the intrinsic
triangulation that --save writes.

Examples:
  intrinsic path bunny.obj --from 17 --to 1000:0.2,0.3,0.5 -o path.vtp
  intrinsic path bunny.obj --from 17 --via 99 --via 612 --loop -o loop.obj --stats loop.json
  intrinsic path bunny.obj --from 0.1,0.2,0 --straightest 30 0.25 -o ray.ply
  intrinsic path eight.off --homology -o loops.vtp --view loops.html)";

const char* const transfer =
  R"(With --points each line of the output has two places, FACE:a,b,c on the mesh and on the
intrinsic triangulation; with --back such lines are read. With --data the output has a value for
each vertex of the other triangulation, in lines "index value": those of the piecewise linear
function that is closest in the L2 norm, which has the same integral. Faces and vertices of the
intrinsic triangulation are those that --save writes. The statistics have the greatest error of
points or values after the way there and back.

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

The triangles need not form a surface, and with --neighbors there may be points alone. Then f
counts faces of the tufted cover, which has two for each triangle, and there is a further file:
  PREFIX_cover_vertices.mtx        values at vertices to those at vertices of the cover (c x v)
The connection Laplacian is c x c.

Example:
  intrinsic operators bunny.obj --prefix bunny --save bunny.txt)";

const char* const flatten =
  R"(The map is discretely conformal. Without --boundary the boundary is not scaled. A surface
without boundary is cut through its cones.

Values of --boundary:
  free       vertices on the boundary are not scaled (the default)
  straight   all exterior angles are zero; cones are placed inside
  scale      --boundary-values FILE prescribes the logarithms of their scale factors
  curvature  --boundary-values FILE prescribes their exterior angles
  rectangle  each component is mapped to a rectangle; its corners are as far apart along the
             boundary as possible with a sum of angles of at least nine tenths of that of the
             four sharpest vertices
  disk       the boundary of each component is mapped to a circle
Rectangles and disks are for components with one boundary. They have no cones unless --cones is
given, as handles require, and then only inside.

A FILE has lines "index value": the index of a vertex, from 0, and radians or a logarithm. What
follows a # is a comment. Vertices that are not listed have curvature zero: they are flat inside,
and straight on the boundary. In the file of --cones the values are angle defects, 2 pi less the
sum of angles; an empty one makes a torus flat. All curvatures must add up to 2 pi times the
Euler characteristic, unless scale factors are prescribed somewhere.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the
flat triangulation. The texture coordinates u, v at the corners of its faces are lengths in the
plane, not limited to one. Charts of components are side by side. With --linear (the default,
which every program reads) they are interpolated linearly; the map itself is projective on each
face, and exact with --homogeneous: three numbers u w, v w, w, to be divided after linear
interpolation.
  .obj  "vt u v", or "vt uw vw w"
  .ply  a list "texcoord" (or "homogeneous_texcoord") of each face, with all numbers of its
        corners
  .vtp  a property with that name of points, which are repeated along seams
.ply and .vtp have for each vertex the input vertex (-1 if it is none), whether it is a cone and
its logarithmic scale factor; of faces (and in .ply of edges) of which input, intrinsic and flat
face or edge they are a part. Edges with is_seam 1 are cut open.

With --exact, the flips to the intrinsic Delaunay triangulation are decided exactly, on the
surface of the positions, whose lengths and curvature errors have 32 digits, and the map is
certified: "certified" in the statistics says whether this triangulation is Delaunay, the flat one
is ideal Delaunay with the scale factors as they are, and all crossings are in order, without a
tolerance. "greatest_excess", "exchanged_crossings", "undecided" and "undecided_crossings" are
what fails: rounding decides ties.

Solvers:
  newton  Newton's method
  ceres   L-BFGS of the Ceres Solver: as accurate, with fewer factorizations and more evaluations
  cetm    Newton's method in the triangulation of the mesh, without flips, for comparison.
          The scale factors depend on the triangulation and often do not exist; the error names the
          violated condition, triangle_inequality or no_minimum.

The file of --matrix has a sparse matrix with one row for each vertex of the output, in the order
of .obj and .ply (.vtp repeats vertices along seams), and one column for each vertex of the mesh.
Its product with values at the vertices of the mesh (positions, colors, logarithmic scale
factors) has the values at the vertices of the output, linear on the faces of the mesh. Each row
has one to three weights, sum one. Rows of vertices of the mesh come first, in their order, so the
matrix starts with the identity.

The image can cover parts of the plane more than once. "overlap_area" in the statistics, and the
last line, have the area of these parts, and "overlapping_charts" the pairs of charts that overlap:
a chart has two equal numbers if it overlaps itself. With --no-overlap charts are cut along edges of
the flat triangulation until none does, and packed. With --unit-square all texture coordinates are
multiplied by one number, "scale" in the statistics, and lie between 0 and 1.

A map that lacks something it should have (curvatures, exterior angles, the shape of its boundary,
length cross ratios, orientation) is not written, and the message says what can be tried. With
--keep-going it is written, with exit code 3; "promises" in the statistics has all errors.
"flipped_triangles" in the statistics leaves out slivers, triangles with heights in space of up to
16 units in the last place of their coordinates; "flipped_slivers" counts those.

Examples:
  intrinsic flatten bunny.obj -o flat.obj --cones greedy --max-log-scale 3
  intrinsic flatten bunny.obj -o atlas.obj --no-overlap --unit-square
  intrinsic flatten face.ply -o flat.ply --boundary disk --stats flat.json)";

const char* const hyperbolic =
  R"(Every component must have genus two or more, or sufficiently many boundaries or cones; for
others there is `intrinsic uniformize`. --component K and --largest choose one. Boundaries become
geodesics. The double of the surface is laid out; the output is the part of the mesh.

The output has the format of `intrinsic flatten`, with positions in the Poincare disk. With
--homogeneous they are x t, y t, t, in Klein's disk, where the map is exact.

Statistics: the area, which is 2 pi (2 genus - 2 + boundaries); for each component its genus,
boundaries and area, and the motions z -> (a z + b) / (conj(b) z + conj(a)) that glue the sides of
its domain, or of that of its double, as real and imaginary parts of a and b; a relation, the order
in which their product is the identity (from 1, negative for inverse ones), and its error as they
are written; these motions with all known digits, where the layout needed more than 16, and the
error of their relation. max_gluing_error is that of the corners of the domain; radius
is the greatest distance from its center: in double precision, positions at a distance d have
errors of about 1e-16 exp(d).

Example:
  intrinsic hyperbolic pretzel.obj -o disk.obj --svg tiling.svg --tiles 4 --stats pretzel.json)";

const char* const uniformize =
  R"(Each component, by its topology, becomes
  a sphere      round, as with `intrinsic sphere`
  a disk        a hemisphere, as with `intrinsic sphere`; its texture is the image in the unit disk
  a torus       flat, as with `intrinsic flatten --cones none`
  a cylinder    with two boundaries and no handles: flat, with straight boundaries
  hyperbolic    with more handles or boundaries, as with `intrinsic hyperbolic`
--svg and --tiles are for hyperbolic surfaces, --homogeneous for these and flat ones.

Statistics are those of these commands, and "modulus": of a torus the quotient tau of the
generators of its lattice in the fundamental domain of the modular group, as real and imaginary
part; of a cylinder the height over the circumference, as imaginary part.

Several components are mapped one by one and written into one mesh, in which the vertices of the
input keep their indices. Their textures stand beside each other, and unit spheres stand in a row,
to the right of the mesh if other components are there. "components" in the statistics has what
each became: the keys above, its number, sizes and first face, and of a sphere its center. If one
has no map, nothing is written, or, with --keep-going, only the others. --component K and --largest
choose one; --view, --picture and --svg show only one.

Example:
  intrinsic uniformize torus.obj -o flat.obj --stats torus.json)";

const char* const sphere =
  R"(Each component must be a sphere or a disk. The image is a convex polyhedron with
vertices on the unit sphere, discretely conformal to the mesh, that has its center of mass (with
areas of the mesh) in the center; or one half of such a polyhedron, with the boundary on the
equator. Convexity is decided exactly. A disk without vertices inside becomes a convex polygon in
the equator, in the plane z = 0: "flat" in the statistics.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the
polyhedron, projected to the sphere. .ply and .vtp have for each vertex the input vertex (-1 if it
is none) and its logarithmic scale factor, its place in the mesh (input_x, input_y, input_z) and
homogeneous coordinates on the polyhedron (homogeneous_x, _y, _z, _w), which are linear on faces;
of faces (and in .ply of edges) of which input, intrinsic and sphere face or edge they are a part.
A disk has its image in the unit disk as texture coordinates.

Long limbs have small images. By rounding of the output, triangles can lose their convexity or be
flipped: lost_in_output in the statistics counts them. --precise writes the positions of the input
vertices with 31 digits, all of which hold: the points are on the unit sphere up to 1e-31.

Vertices without faces are (0, 0, 1) or beside a disk (1, 0, 0), with homogeneous coordinates
zero. If the image is not convex, nothing is written but with --keep-going.

Several components are mapped one by one. Their spheres stand beside each other along the x axis,
as "center" in the "components" of the statistics says; positions of --precise are relative to
it, and vertices without faces stay where they are. --component K and --largest choose one.

Example:
  intrinsic sphere cow.off -o sphere.ply --stats sphere.json --precise sphere.txt)";

const char* const simplify =
  R"(Vertices are removed one by one, the one of least cost first. The result is an intrinsic
Delaunay triangulation of a surface whose distances are close to those of the mesh; vertices keep
their positions. The cost of a removal is a length: the distance by which curvature and area,
with their weights, have been moved, times their part of the whole. Changes of area cost, too, at
the boundary most, so that corners of flat parts stay. With --weight, weights that are not given
are zero, and the last line names those in force. With a weight of color (in
.ply, .off and .obj) or of any function at the vertices (properties in .ply, by their names), its
Laplacian is moved too, so that more vertices stay where its gradient changes. --error is the
greatest cost of a removal. If no vertex can be removed, simplification ends early, with exit
code 0 and the status "nothing_removable" in the statistics. Vertices without faces stay;
--vertices and --ratio do not count them.

With --min-angle, vertices are finally inserted into the coarse triangulation until its angles
obey the bound, except at narrow vertices, as by `intrinsic refine`. All output is about the
refined coarse triangulation.

With --close-loops and --pinch-handles the topology is simplified first: boundary loops up to a
length are closed, and handles are cut along closed curves of edges up to a length, the shortest
first, and closed on both sides, each by a disk of triangles around a new vertex. The rest of the
mesh does not change. Faces of the disks have -1 as "input_face"; in the output their vertex is
in the middle of the others, but lengths are those of the disk. Lengths are in the units of the
mesh.

With --exact, the refinement before and the intrinsic Delaunay triangulation from which vertices
are removed are decided exactly and certified, as by `intrinsic delaunay --exact`. Removals
change the surface by rounded numbers, and are decided in floating point.

The output is the common subdivision of the mesh and the coarse triangulation. In .ply and .vtp
faces have the properties "coarse_face" and "input_face", and a color by which adjacent coarse
faces differ; in .ply edges have "coarse_edge" and "input_edge", or -1, and .vtp has the coarse
edges as polylines. Vertices have the properties "coarse_vertex", or -1, and "kind": 0 input
vertex, 1 crossing of a coarse edge with an edge, 2 inserted vertex, 3 bend of a coarse edge
inside a face. With --refine more edges lead to the inserted vertices, within the
faces of the mesh.

The file of --coarse has the coarse triangulation as an ordinary mesh, for other programs: vertices
where they are on the mesh, edges straight, faces flat. Vertices have the property "input_vertex"
in .ply and .vtp, -1 for those that were inserted because there were loops or several edges with
the same ends. The coarse triangulation is close to the mesh in its lengths, not in space. The last
line and "coarse_mesh" in the statistics have the deviation, the greatest distance of a vertex of
the mesh from the coarse mesh and of the middle of a coarse edge or face from the mesh, and the
numbers of faces that are flipped or without area and of pairs of faces that intersect.

P of --prolongation has a row for each vertex of the mesh and a column for each coarse vertex. Its
rows are barycentric coordinates: not negative, with sum 1. With L levels there are L matrices,
P_1.mtx to P_L.mtx, each from one level to the one before; the vertices of the levels are those of
the mesh that are left, in their order. Vertices inserted by --refine follow those of the mesh;
they can be coarse vertices, but have no rows in the first matrix. Those of --min-angle are the
last of the coarse vertices.

--save writes all levels and the operations between them, with --refine after the mesh with the
inserted vertices.

Examples:
  intrinsic simplify bunny.obj -o coarse.vtp --vertices 500 --prolongation P.mtx
  intrinsic simplify bunny.obj --coarse small.obj --vertices 500)";

} // namespace Help
