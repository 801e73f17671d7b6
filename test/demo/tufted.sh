#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Triangles that are no oriented surface: the commands operators and distance work on their cover,
# the others refuse them.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# book NAME N PAGES...: squares of N x N cells around the z-axis at these angles; every second face is
# turned over. Vertex j of the spine has the number j.
book()
{
  awk -v n="$2" -v angles="${*:3}" 'BEGIN {
    pages = split(angles, angle, " ")
    print "OFF\n" (n + 1) * (1 + pages * n), pages * 2 * n * n, 0
    for(j = 0; j <= n; ++j)
      print 0, 0, j / n
    for(p = 1; p <= pages; ++p)
      for(i = 1; i <= n; ++i)
        for(j = 0; j <= n; ++j)
          print i / n * cos(angle[p]), i / n * sin(angle[p]), j / n
    for(p = 1; p <= pages; ++p)
      for(i = 0; i < n; ++i)
        for(j = 0; j < n; ++j) {
          a = (i ? 1 + (p - 1) * n + i - 1 : 0) * (n + 1) + j
          b = (1 + (p - 1) * n + i) * (n + 1) + j
          if((i + j) % 2) { print 3, a, b, b + 1; print 3, a, a + 1, b + 1 }
          else { print 3, b, a, b + 1; print 3, a, b + 1, a + 1 }
        }
  }' >"$1.mesh.off"
}

soups='edge_of_three bow_tie orientation'
for mesh in $soups; do
  for command in "delaunay $mesh.mesh.off -o a.ply" "refine $mesh.mesh.off -o a.ply" \
    "simplify $mesh.mesh.off -o a.ply --ratio 0.5" "sphere $mesh.mesh.off -o a.ply"; do
    refuses '; --repair makes it a surface' $command
  done
  expect 0 operators $mesh.mesh.off --prefix a --stats a.json
  says "$mesh.mesh.off: note: no oriented surface, so its tufted cover is used"
  has_keys a.json $surface_keys tufted non_manifold_edges non_manifold_vertices \
    inconsistently_oriented_edges cover vertices edges faces flips $edge_keys matrices seconds read build flip write \
    peak_memory_bytes
  claim "s = json('a.json')" 's.tufted' 's.cover.faces == 2 * s.faces' 'len(s.matrices) == 7' \
    's.non_manifold_edges + s.non_manifold_vertices + s.inconsistently_oriented_edges == 1' \
    "laplacian = mtx('a_laplacian.mtx')" 'one = [1] * s.vertices' \
    'near(laplacian @ one, [0] * len(one), 1e-14)' \
    "near(mtx('a_mass.mtx') @ one, mtx('a_lumped_mass.mtx') @ one, 1e-14)"
  rm a*
  # repaired, they are surfaces
  expect 0 operators $mesh.mesh.off --prefix a --stats a.json --repair
  ! grep -q tufted a.json || fail 'a surface has no cover'
  rm a*
done

# Areas are those of the triangles.
expect 0 operators edge_of_three.mesh.off --prefix a
claim "near(fsum(mtx('a_lumped_mass.mtx') @ ([1] * 5)), 1.5, 1e-14)"
# Functions on the cover are those on the vertices, and each has three or more copies of these.
claim "m = mtx('a_cover_vertices.mtx')" 'set(m @ ([1] * 5)) == {1}'
rm a*

# On a book the distance to a vertex of one page is that of two pages unfolded.
book book 16 0.5 2 3 4.5
expect 0 distance book.mesh.off --source 144 -o a.ply --subdivision b.ply --stats a.json
claim "a, m = ply('a.ply'), off('book.mesh.off')" '(a.points, a.faces) == (m.points, m.faces)' \
  "d = a.vertex['distance']" 'd[144] == 0' 'x = [hypot(*p[:2]) for p in m.points]' \
  'truth = [hypot(x[i] - (x[144] if 17 <= i < 289 else -x[144]), p[2] - m.points[144][2])
     for i, p in enumerate(m.points)]' \
  'sum(abs(s - t) for s, t in zip(d, truth)) <= 0.03 * sum(truth)'
claim "b = ply('b.ply')" "{f for f in b.face['input_face']} == set(range(2048))" \
  "set(b.face['is_back']) == {0, 1}" "max(b.vertex['distance']) == max(ply('a.ply').vertex['distance'])"
refuses 'the vertices are 0 to 1104' distance book.mesh.off --source 1105 -o a.ply
# Refined, certified, mollified.
expect 0 distance book.mesh.off --source 144 -o a.ply --min-angle 30 --exact --stats a.json
claim "json('a.json').certified"
claim "len(ply('a.ply').vertex['distance']) == 1105"
expect 0 operators book.mesh.off --prefix a --min-angle 30 --mollify 1e-3
rm a* b*

# Defects of another kind are errors still.
off bad '0 0 0,1 0 0,1 1 0,0 1 0,0 0 1' '0 1 2,1 0 3,0 1 4,0 2 2'
refuses 'face with a repeated vertex: 1, first at face 3' operators bad.mesh.off --prefix a
off zero '0 0 0,1 0 0,1 1 0,0 1 0,0 0 0' '0 1 2,1 0 3,0 1 4'
refuses 'zero-length edge: 1' operators zero.mesh.off --prefix a
expect 0 operators zero.mesh.off --prefix a --mollify 1e-3
rm a*
expect_files
