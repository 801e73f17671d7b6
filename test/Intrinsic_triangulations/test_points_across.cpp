// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hard_meshes.h"
#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/point_across.h>

namespace Test_points_across {

using namespace Test_surfaces;

void expect_in_face(const Location& p)
{
  double sum = 0;
  for(double b : p.second) {
    EXPECT_GE(b, 0);
    sum += b;
  }
  EXPECT_NEAR(sum, 1, 1e-15);
}

// Returns some points inside faces, and some on their edges.
std::vector<Location> sample(const Delta_complex& mesh, std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Location> result;
  for(std::size_t i = 0; i < n; ++i) {
    Location p = random_location(mesh, random);
    if(i % 4 == 0) {
      p.second[0] += p.second[i / 4 % 3];
      p.second[i / 4 % 3] = 0;
      const double sum = p.second[0] + p.second[1] + p.second[2];
      for(double& b : p.second)
        b /= sum;
    }
    result.push_back(p);
  }
  return result;
}

void check_there_and_back(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides) {
    const Flat_faces faces(side, t);
    const double size = static_cast<double>(faces.longest_edge());
    for(const Location& p : sample(faces.mesh(), 40, 1)) {
      const Location q = IT::point_across(c, side, p);
      expect_in_face(q);
      const Location back = IT::point_across(c, other(side), q);
      expect_in_face(back);
      EXPECT_LT(static_cast<double>(faces.path(p, back)) / size, 1e-9);
    }
  }
}

void expect_single_equals_many(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides)
    for(const Location& p : sample(c.mesh(side), 10, 2)) {
      const Location many = IT::point_across(c, side, p), single = IT::point_across(t, side, p);
      EXPECT_EQ(many.first, single.first);
      for(std::size_t s = 0; s < 3; ++s)
        EXPECT_NEAR(many.second[s], single.second[s], 1e-11); // of two ways to lay out the edges
    }
}

void check_vertices(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides) {
    const Flat_faces faces(side, t), other_faces(other(side), t);
    for(Halfedge_index h : faces.mesh().halfedges())
      if(!faces.mesh().is_border(h)) {
        const Location q = IT::point_across(c, side, faces.on(h, 0));
        const auto corner = std::find(q.second.begin(), q.second.end(), 1.);
        ASSERT_NE(corner, q.second.end());
        EXPECT_EQ(std::count(q.second.begin(), q.second.end(), 0.), 2);
        const auto s = static_cast<std::size_t>(corner - q.second.begin());
        EXPECT_EQ(other_faces.mesh().source(other_faces.sides(q.first)[s]), faces.mesh().source(h));
      }
  }
}

void check_shared_edges(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides) {
    const Flat_faces faces(side, t), other_faces(other(side), t);
    for(Halfedge_index h : faces.mesh().halfedges())
      if(!faces.mesh().is_border(h) && c.is_shared(side, Edge_index(h)))
        for(double x : {1e-300, 1e-17, 0.1, 0.7, 1 - 1e-16}) {
          const Location q = IT::point_across(c, side, faces.on(h, x));
          const auto zero = std::find(q.second.begin(), q.second.end(), 0.);
          ASSERT_NE(zero, q.second.end());
          const Halfedge_index twin = c.outgoing_before(side, h);
          if(q.first == other_faces.mesh().face(twin))
            EXPECT_LT(other_faces.path(q, other_faces.on(twin, x)),
                      1e-15 * other_faces.length(twin))
              << x;
          else
            EXPECT_EQ(x, 1e-300); // too near the vertex to tell which of its faces it is in
        }
  }
}

// Checks a point on an edge, seen from both faces.
void check_continuity(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides) {
    const Flat_faces faces(side, t), other_faces(other(side), t);
    const double size = static_cast<double>(faces.longest_edge());
    for(Halfedge_index h : faces.mesh().halfedges())
      if(!faces.mesh().is_border(Edge_index(h)))
        for(double x : {0.03, 0.2, 0.5, 0.9}) {
          const Halfedge_index o = faces.mesh().opposite(h);
          const Location left = IT::point_across(c, side, faces.on(h, x));
          const Location right = IT::point_across(c, side, faces.on(o, 1 - x));
          EXPECT_LT(static_cast<double>(other_faces.path(left, right)) / size, 1e-9);
        }
  }
}

// ---- Flat surfaces ----

// Returns the position in the plane, as seen from one corner; modulo the lattice.
Place flat_place(const Location& p, const Flat_faces& faces, const Flat_surface& surface,
                 const std::function<Vector(Halfedge_index)>& vector)
{
  const auto side = faces.sides(p.first);
  const Vector first = surface.point[faces.mesh().source(side[0])];
  const Vector u = vector(side[0]), v = -vector(side[2]);
  return {Real(first.x) + p.second[1] * Real(u.x) + p.second[2] * Real(v.x),
          Real(first.y) + p.second[1] * Real(u.y) + p.second[2] * Real(v.y)};
}

Real distance_modulo_lattice(const Place& p, const Place& q, const Flat_surface& surface)
{
  const Place a{Real(surface.a.x), Real(surface.a.y)}, b{Real(surface.b.x), Real(surface.b.y)};
  const Place d = p - q;
  return norm(d - std::round(det(d, b) / det(a, b)) * a - std::round(det(a, d) / det(a, b)) * b);
}

void check_flat(const Flat_triangulation& flat)
{
  const Correspondence c(*flat);
  for(Side side : both_sides) {
    const auto vector_of = [&](Side of) {
      return [&flat, of](Halfedge_index h) {
        return of == Side::input ? flat.input_vector(h) : flat.vector(h);
      };
    };
    const Flat_faces faces(side, *flat), other_faces(other(side), *flat);
    for(const Location& p : sample(faces.mesh(), 100, 3)) {
      const Location q = IT::point_across(c, side, p);
      const Place here = flat_place(p, faces, flat.surface(), vector_of(side));
      const Place there = flat_place(q, other_faces, flat.surface(), vector_of(other(side)));
      EXPECT_LT(static_cast<double>(distance_modulo_lattice(here, there, flat.surface()) /
                                    faces.longest_edge()),
                1e-12);
    }
  }
}

// ---- Geodesics from vertices ----

// Stores signposts, which are independent of integer coordinates. They are the angles between the
// halfedges of T2 and the first outgoing halfedge of T1 around every vertex, updated by flips.
class Signposts
{
public:
  explicit Signposts(const Triangulation& t)
    : m_triangulation(t), m_angle(t.mesh().number_of_halfedges()), m_total(t.mesh().num_vertices())
  {
    const Flat_faces faces(Side::input, t);
    for(Vertex_index v : t.mesh().vertices()) {
      Halfedge_index h = IT::first_outgoing_halfedge(v, t.input_mesh());
      do {
        m_angle[h] = m_total[v];
        if(t.input_mesh().is_border(h))
          break;
        m_total[v] += faces.angle(h);
        h = IT::next_around_source(h, t.input_mesh());
      } while(h != IT::first_outgoing_halfedge(v, t.input_mesh()));
    }
    m_input_angle = m_angle;
  }

  void after_flip(Halfedge_index h)
  {
    const Delta_complex& mesh = m_triangulation.mesh();
    for(Halfedge_index x : {h, mesh.opposite(h)}) {
      const Halfedge_index before = IT::previous_around_source(x, mesh);
      m_angle[x] =
        reduced(m_angle[before] + Flat_faces(Side::intrinsic, m_triangulation).angle(before),
                mesh.source(x));
    }
  }

  // Returns the position of a point of T1 on T2, by the direction and length of the line from a
  // corner to it.
  Location across(const Location& p, std::size_t corner) const
  {
    const Flat_faces faces(Side::input, m_triangulation);
    const Halfedge_index h = faces.sides(p.first)[corner];
    const Place place = faces.place(h, p);
    const Vertex_index v = faces.mesh().source(h);
    return walk(v, reduced(m_input_angle[h] + std::atan2(place.y, place.x), v), norm(place));
  }

private:
  Real reduced(Real angle, Vertex_index v) const
  {
    return m_triangulation.mesh().is_border(v) ? angle : std::fmod(angle, m_total[v]);
  }

  Location walk(Vertex_index v, Real direction, Real distance) const
  {
    const Delta_complex& mesh = m_triangulation.mesh();
    const Flat_faces faces(Side::intrinsic, m_triangulation);
    Halfedge_index best;
    Real least = std::numeric_limits<Real>::infinity();
    Halfedge_index h = IT::first_outgoing_halfedge(v, mesh);
    do { // the last outgoing halfedge before the direction
      const Real turn = m_angle[h] <= direction + 1e-12L ? direction - m_angle[h]
                                                         : direction - m_angle[h] + m_total[v];
      if(!mesh.is_border(h) && turn < least) {
        least = turn;
        best = h;
      }
      h =
        mesh.is_border(h) ? IT::first_outgoing_halfedge(v, mesh) : IT::next_around_source(h, mesh);
    } while(h != IT::first_outgoing_halfedge(v, mesh));
    return unfold(best, {distance * std::cos(least), distance * std::sin(least)});
  }

  // Unfolds face after face along the line from the origin, the source of `outgoing`, to `end`.
  Location unfold(Halfedge_index outgoing, const Place& end) const
  {
    const Delta_complex& mesh = m_triangulation.mesh();
    const Flat_faces faces(Side::intrinsic, m_triangulation);
    auto corner = faces.layout(outgoing);
    Halfedge_index h = outgoing; // the layout is that of its source, its target and its apex
    Halfedge_index exit = mesh.next(h);
    for(int steps = 0; steps < 1000; ++steps) {
      const std::size_t s = exit == mesh.next(h) ? 1 : exit == mesh.prev(h) ? 2 : 0;
      const Place a = corner[s], b = corner[(s + 1) % 3];
      if(det(b - a, end - a) >= 0 || mesh.is_border(mesh.opposite(exit)))
        return located(h, corner, end);
      h = mesh.opposite(exit);
      const Place unit = (1 / norm(a - b)) * (a - b), apex = faces.layout(h)[2];
      corner = {b, a,
                b + Place{apex.x * unit.x - apex.y * unit.y, apex.x * unit.y + apex.y * unit.x}};
      exit = det(end, corner[2]) > 0 ? mesh.next(h) : mesh.prev(h);
    }
    ADD_FAILURE() << "the line does not end";
    return {};
  }

  Location located(Halfedge_index h, const std::array<Place, 3>& corner, const Place& p) const
  {
    const Real area = det(corner[1] - corner[0], corner[2] - corner[0]);
    const std::array<Real, 3> b{det(corner[2] - corner[1], p - corner[1]) / area,
                                det(corner[0] - corner[2], p - corner[2]) / area,
                                det(corner[1] - corner[0], p - corner[0]) / area};
    const auto side =
      Flat_faces(Side::intrinsic, m_triangulation).sides(m_triangulation.mesh().face(h));
    Location result{m_triangulation.mesh().face(h), {}};
    for(std::size_t s = 0; s < 3; ++s)
      result.second[s] = static_cast<double>(b[side[s] == h ? 0 : side[(s + 2) % 3] == h ? 1 : 2]);
    return result;
  }

  const Triangulation& m_triangulation;
  std::vector<Real> m_angle, m_input_angle, m_total;
};

void check_by_geodesics(Triangulation t, unsigned int seed)
{
  Signposts signposts(t);
  flip_at_random(t, 20 * t.mesh().number_of_edges(), seed,
                 [&](Halfedge_index h) { signposts.after_flip(h); });
  const Correspondence c(t);
  const Flat_faces faces(Side::intrinsic, t);
  CGAL::Random random(seed);
  for(int i = 0; i < 30; ++i) {
    const Location p = random_location(t.input_mesh(), random);
    const Location q = IT::point_across(c, Side::input, p);
    const Location expected = signposts.across(p, static_cast<std::size_t>(i % 3));
    EXPECT_LT(static_cast<double>(faces.path(q, expected) / faces.longest_edge()), 1e-9) << i;
  }
}

// Applies a check to each of the triangulations.
void check_all(void (&check)(const Triangulation&))
{
  for(const Named_triangulation& t : traced(triangulations()))
    check(t.triangulation);
}

// The vertices of add_face() and of vertices_around_face() belong to the coordinates 1, 2, 0.
TEST(Face_location, corners_are_those_of_CGAL)
{
  Mesh mesh;
  const Vertex_index a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
                     c = mesh.add_vertex({0, 1, 0});
  const Face_index f = mesh.add_face(a, b, c);
  const Triangulation t(mesh);
  const auto side = IT::sides(f, t.input_mesh());
  std::vector<Vertex_index> corners, around_face;
  for(const Halfedge_index h : side)
    corners.push_back(t.input_mesh().source(h));
  for(const Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    around_face.push_back(v);
  EXPECT_EQ(corners, (std::vector{c, a, b}));
  EXPECT_EQ(around_face, (std::vector{a, b, c}));
  const Location p{f, {0.6, 0.3, 0.1}};
  EXPECT_EQ(IT::coordinates_from(side[1], p, t.input_mesh()), (std::array{0.3, 0.1, 0.6}));
  mesh.set_halfedge(f, side[1]);
  const Triangulation turned(mesh);
  EXPECT_EQ(turned.input_mesh().source(IT::sides(f, turned.input_mesh())[0]), a);
}

TEST(Point_across, there_and_back) { check_all(check_there_and_back); }

TEST(Point_across, single_equals_many) { check_all(expect_single_equals_many); }

TEST(Point_across, vertices_go_to_vertices) { check_all(check_vertices); }

TEST(Point_across, points_on_shared_edges_stay_there) { check_all(check_shared_edges); }

TEST(Point_across, continuous_across_edges) { check_all(check_continuity); }

TEST(Point_across, places_on_flat_surfaces)
{
  for(const auto& [s, seed] : traced(flat_surfaces(), 5)) {
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
    check_flat(flat);
    flat.make_Delaunay();
    check_flat(flat);
  }
}

TEST(Point_across, ends_of_geodesics)
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    for(const Named_mesh& m : meshes()) {
      SCOPED_TRACE(m.name + ", seed " + std::to_string(seed));
      check_by_geodesics(Triangulation(m.mesh), seed);
    }
    for(const Named_complex& c : complexes()) {
      SCOPED_TRACE(c.name + " with random lengths, seed " + std::to_string(seed));
      check_by_geodesics(triangulation(c.mesh, random_lengths(c.mesh, seed)), seed);
    }
  }
}

TEST(Point_across, boundary_stays_boundary)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Correspondence c(t.triangulation);
    for(Side side : both_sides) {
      const Delta_complex& mesh = c.mesh(side);
      const Flat_faces faces(side, t.triangulation), other_faces(other(side), t.triangulation);
      for(Halfedge_index h : mesh.halfedges())
        if(mesh.is_border(mesh.opposite(h))) {
          const Location q = IT::point_across(c, side, faces.on(h, 0.3));
          const auto on_border = [&](std::size_t s) {
            return q.second[(s + 2) % 3] == 0 &&
                   other_faces.mesh().is_border(Edge_index(other_faces.sides(q.first)[s]));
          };
          EXPECT_TRUE(on_border(0) || on_border(1) || on_border(2));
        }
    }
  }
}

// Checks that a point does not move along regions thinner than rounding errors.
void expect_the_same_place_after_there_and_back(const Mesh& mesh, unsigned int seed)
{
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  const Correspondence c(t);
  const Flat_faces input(Side::input, t);
  double farthest = 0;
  for(const Location& p : sample(input.mesh(), 100, seed)) {
    const Location back = IT::point_across(c, Side::intrinsic, IT::point_across(c, Side::input, p));
    farthest =
      (std::max)(farthest, CGAL::squared_distance(place_in_space(p, input.mesh(), mesh),
                                                  place_in_space(back, input.mesh(), mesh)));
  }
  EXPECT_LT(std::sqrt(farthest) / longest_input_edge(t), 1e-8);
}

TEST(Point_across, there_and_back_between_near_coincident_vertices)
{
  for(double distance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for(unsigned int seed = 0; seed < 5; ++seed)
      for(const Named_mesh& m : meshes()) {
        SCOPED_TRACE(m.name + ", seed " + std::to_string(seed) + ", " +
                     std::to_string(-std::log10(distance)) + " digits");
        expect_the_same_place_after_there_and_back(
          with_near_coincident_vertices(m.mesh, distance, seed), seed);
      }
}

TEST(Point_across, there_and_back_on_hard_meshes)
{
  for_each_hard_mesh([](const Mesh& mesh) {
    for(unsigned int seed = 0; seed < 10; ++seed)
      expect_the_same_place_after_there_and_back(mesh, seed);
  });
}

} // namespace Test_points_across
