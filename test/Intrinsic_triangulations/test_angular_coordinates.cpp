// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Angular_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/tangent_vector_across.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

namespace Test_angular_coordinates {

using namespace Test_surfaces;
using Complex = std::complex<double>;
using Angles = IT::Angular_coordinates<>;

void expect_same_direction(double a, double b, double tolerance)
{
  EXPECT_NEAR(std::remainder(a - b, 2 * pi), 0, tolerance) << a << ' ' << b;
}

// Returns the angle from the first crossing of `h` with an edge of T1 that comes from T2.
double angle_from_crossing(Halfedge_index h, const Triangulation& t,
                           const IT::Tangent_frames<>& frames)
{
  if(t.coordinates().is_shared(t.mesh().edge(h)))
    return frames.angle(t.input_halfedge(h));
  const Edge_place p = IT::trace_intrinsic_edge(t, h)[1].on_input;
  const Location location = IT::face_location(p, t.input_mesh());
  return std::arg(IT::logarithm(t.input(), t.input_mesh().prev(p.halfedge), location));
}

// Returns the angle from exact vectors; `frames` determines the angle sum on the boundary.
double angle_in_plane(Halfedge_index h, const Flat_triangulation& flat,
                      const IT::Tangent_frames<>& frames)
{
  const Vertex_index v = flat->mesh().source(h);
  const Halfedge_index first = IT::first_outgoing_halfedge(v, flat->input_mesh());
  const double angle = std::arg(complex(flat.vector(h)) / complex(flat.input_vector(first)));
  if(!flat->mesh().is_border(v))
    return angle;
  const double positive = angle < -1e-9 ? angle + 2 * pi : angle;
  return positive * pi / frames.angle_sum(v);
}

// Checks that updated angles equal recomputed angles.
void check_kept(const Angles& kept, const Triangulation& t, double tolerance)
{
  const Angles fresh(t);
  for(Halfedge_index h : t.mesh().halfedges()) {
    expect_same_direction(kept.angle(h), fresh.angle(h), tolerance);
    if(t.coordinates().is_shared(t.mesh().edge(h))) {
      EXPECT_EQ(kept.angle(h), fresh.angle(h));
    }
  }
}

// ---- Inserted vertices ----

// Flips, insertions into faces and edges, and removals at random, of which visitors hear. Only
// those are made that give faces fat enough for nine digits.
template <typename Visitor>
class Random_changes
{
public:
  Random_changes(Triangulation& t, unsigned int seed, Visitor& visitor)
    : m_t(t), m_mesh(t.mesh()), m_random(seed), m_inserter(t), m_visitor(visitor)
  {}

  void change(std::size_t attempts)
  {
    for(std::size_t i = 0; i < attempts; ++i)
      switch(m_random.get_int(0, 8)) {
        case 0: split_face(Face_index(number(m_mesh.num_faces()))); break;
        case 1: split_edge(halfedge()); break;
        case 2: remove(Vertex_index(number(m_mesh.num_vertices()))); break;
        default: flip(halfedge());
      }
  }

  std::array<std::size_t, 3> counts{}; // splits of faces and edges, and removals

private:
  Delta_complex::size_type number(std::size_t n)
  {
    return static_cast<Delta_complex::size_type>(m_random.get_int(0, static_cast<int>(n)));
  }
  Halfedge_index halfedge() { return Halfedge_index(number(m_mesh.num_halfedges())); }

  bool is_fat(Face_index f, const Triangulation& t) const
  {
    return Flat_faces(Side::intrinsic, t).area(f) > 2e-3 * m_size * m_size;
  }

  bool are_fat(Halfedge_index h, const Triangulation& t) const
  {
    return is_fat(t.mesh().face(h), t) && is_fat(t.mesh().face(t.mesh().opposite(h)), t);
  }

  void split_face(Face_index f)
  {
    if(m_mesh.is_removed(f) || !is_fat(f, m_t))
      return;
    const double u = m_random.get_double(0.2, 0.4), v = m_random.get_double(0.2, 0.4);
    const Location p{f, {1 - u - v, u, v}};
    const auto side = Flat_faces(Side::intrinsic, m_t).sides(f);
    const Vertex_index m = m_inserter.insert(p);
    m_visitor.after_face_split(side, p);
    m_visitor.after_insertion(m, m_inserter);
    ++counts[0];
  }

  void split_edge(Halfedge_index h)
  {
    if(m_mesh.is_removed(h) || m_mesh.is_border(h) || !m_inserter.can_be_split(h) ||
       !is_fat(m_mesh.face(h), m_t))
      return;
    const double t = m_random.get_double(0.2, 0.8);
    const Vertex_index m = m_inserter.split_edge(h, t);
    m_visitor.after_edge_split(h, t);
    m_visitor.after_insertion(m, m_inserter);
    ++counts[1];
  }

  void remove(Vertex_index v)
  {
    if(!m_t.is_inserted(v) || m_mesh.is_removed(v))
      return;
    if(!can_be_removed(v))
      return;
    const Face_index f = m_inserter.remove(v, [&](Halfedge_index h) { m_visitor.after_flip(h); });
    ASSERT_TRUE(f.is_valid());
    m_visitor.after_removal(v, f);
    ++counts[2];
  }

  // Returns whether a vertex can be removed, by a trial on a copy.
  bool can_be_removed(Vertex_index v) const
  {
    Triangulation t = m_t;
    bool result = true;
    const Face_index f = IT::Vertex_inserter<>(t).remove(
      v, [&](Halfedge_index h) { result = result && are_fat(h, t); });
    return result && f.is_valid() && is_fat(f, t);
  }

  void flip(Halfedge_index h)
  {
    if(m_mesh.is_removed(h) || !m_t.is_flippable(h) || convexity(m_t, h) < 0.1)
      return;
    flip_and_tell(h);
    if(!are_fat(h, m_t)) // back again
      flip_and_tell(h);
  }

  void flip_and_tell(Halfedge_index h)
  {
    m_inserter.flip(h);
    m_visitor.after_flip(h);
  }

  Triangulation& m_t;
  const Delta_complex& m_mesh;
  double m_size = longest_input_edge(m_t);
  CGAL::Random m_random;
  IT::Vertex_inserter<> m_inserter;
  Visitor& m_visitor;
};

// Keeps the angles, but no vectors.
struct Angles_only : Angles
{
  using Angles::Angles;
  void after_face_split(const std::array<Halfedge_index, 3>&, const Location&) {}
  void after_edge_split(Halfedge_index, double) {}
};

// Stores the vectors of the halfedges of T2 in the plane, and the angles.
class Plane_vectors : public Angles
{
public:
  explicit Plane_vectors(const Flat_triangulation& flat, const Triangulation& t)
    : Angles(t), m_mesh(t.mesh()), m_vector(t.mesh().num_halfedges())
  {
    for(Halfedge_index h : m_mesh.halfedges())
      m_vector[h] = complex(flat.vector(h));
  }

  const Complex& vector(Halfedge_index h) const { return m_vector[h]; }

  void after_flip(Halfedge_index h)
  {
    close(h);
    Angles::after_flip(h);
  }

  void after_face_split(const std::array<Halfedge_index, 3>& side, const Location& p)
  {
    m_vector.resize(m_mesh.num_halfedges());
    const auto& b = p.second;
    const std::array<Complex, 3> v{m_vector[side[0]], m_vector[side[1]], m_vector[side[2]]};
    for(std::size_t k = 0; k < 3; ++k) // to the source of side k
      set(m_mesh.prev(side[k]), b[(k + 2) % 3] * v[(k + 2) % 3] - b[(k + 1) % 3] * v[k]);
  }

  void after_edge_split(Halfedge_index h, double t)
  {
    m_vector.resize(m_mesh.num_halfedges());
    const Halfedge_index o = m_mesh.opposite(h);
    const Complex v = m_vector[h];
    const Halfedge_index im = m_mesh.prev(m_mesh.opposite(m_mesh.prev(h)));
    set(im, t * v);
    set(h, (1 - t) * v);
    close(m_mesh.prev(h));
    if(!m_mesh.is_border(o))
      close(m_mesh.next(o));
  }

  void after_removal(Vertex_index v, Face_index f)
  {
    for(Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh)) {
      const double l = triangulation().length(m_mesh.edge(h));
      if(std::abs(std::abs(m_vector[h]) - l) > 1e-6 * l) // it has taken the place of two
        close(h);
    }
    Angles::after_removal(v, f);
  }

private:
  void set(Halfedge_index h, const Complex& v)
  {
    m_vector[h] = v;
    m_vector[m_mesh.opposite(h)] = -v;
  }
  void close(Halfedge_index h) { set(h, -(m_vector[m_mesh.next(h)] + m_vector[m_mesh.prev(h)])); }

  const Delta_complex& m_mesh;
  std::vector<Complex> m_vector;
};

// Returns the real axis of T1's frame at the source of `h`.
Halfedge_index input_axis(Halfedge_index h, const Triangulation& t)
{
  const Vertex_index v = t.mesh().source(h);
  if(!t.is_inserted(v))
    return IT::first_outgoing_halfedge(v, t.input_mesh());
  return t.outgoing_halfedges().degree(v) > 0
           ? t.outgoing_halfedges().halfedge(v, 0)
           : t.input_mesh().halfedge(std::get<Location>(t.inserted_vertex(v)).first);
}

double angle_in_plane(Halfedge_index h, const Plane_vectors& vectors,
                      const Flat_triangulation& flat)
{
  const Triangulation& t = vectors.triangulation();
  const double angle = std::arg(vectors.vector(h) / complex(flat.input_vector(input_axis(h, t))));
  const Vertex_index v = t.mesh().source(h);
  const double positive = angle < -1e-9 && t.mesh().is_border(v) ? angle + 2 * pi : angle;
  return t.mesh().is_border(v) && !t.is_inserted(v) ? positive * pi / vectors.frames().angle_sum(v)
                                                    : positive;
}

// Checks that a walk over T1 from an inserted vertex in the direction of `h`, for its length, leads
// to its other end.
void check_by_walking(const Triangulation& t, const Angles& angles)
{
  const Flat_faces faces(Side::input, t);
  const double size = longest_input_edge(t);
  for(Halfedge_index h : t.mesh().halfedges()) {
    if(t.mesh().is_border(Edge_index(h)))
      continue;
    const Complex vector = std::polar(t.length(t.mesh().edge(h)), angles.angle(h));
    const auto g = IT::trace_geodesic(t, Side::input, t.mesh().source(h), vector);

    const Location end = t.input_location(t.mesh().opposite(h));
    EXPECT_LT(static_cast<double>(faces.path(g.end, end)), 1e-9 * size) << h;
  }
}

// Checks that the angles between neighbors around `v` agree in the angular coordinates and in the
// corners of T2.
void check_around(Vertex_index v, const Angles& angles)
{
  const Triangulation& t = angles.triangulation();
  IT::for_each_outgoing_halfedge(v, t.mesh(), [&](Halfedge_index h) {
    EXPECT_NEAR(std::remainder(angles.angle(h) - IT::angle_on_input(t, h), 2 * pi), 0, 1e-9);
    if(t.mesh().is_border(h))
      return;
    const double corner = angle_at(h, t.mesh(), t.length_map());
    const double gap = angles.angle(IT::next_around_source(h, t.mesh())) - angles.angle(h);
    const double scale = t.is_inserted(v) ? 1 : angles.frames().scale(v);
    EXPECT_NEAR(std::remainder(gap - scale * corner, 2 * pi), 0, 1e-9);
  });
}

bool is_link_inserted(Vertex_index v, const Triangulation& t)
{
  bool result = !t.mesh().is_border(v);
  IT::for_each_outgoing_halfedge(v, t.mesh(), [&](Halfedge_index h) {
    result = result && t.mesh().target(h) != v && t.is_inserted(t.mesh().target(h)) &&
             !t.mesh().is_border(t.mesh().target(h));
  });
  return result;
}

// Returns the product of the transports along the link.
Complex holonomy_around(Vertex_index v, const Angles& angles)
{
  const Delta_complex& mesh = angles.triangulation().mesh();
  Complex product = 1;
  IT::for_each_outgoing_halfedge(
    v, mesh, [&](Halfedge_index h) { product *= angles.transport(mesh.next(h)); });
  return product;
}

TEST(Angular_coordinates, of_vectors_in_the_plane)
{
  for(const auto& [s, seed] : traced(flat_surfaces(), 3)) {
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
    const IT::Tangent_frames<> frames(flat->input());
    for(Halfedge_index h : flat->mesh().halfedges())
      expect_same_direction(IT::angle_on_input(*flat, h), angle_in_plane(h, flat, frames), 1e-12);
  }
}

TEST(Angular_coordinates, of_crossings)
{
  for(const Named_triangulation& named : traced(triangulations())) {
    const Triangulation& t = named.triangulation;
    const IT::Tangent_frames<> frames(t.input());
    const Angles angles(t);
    for(Halfedge_index h : t.mesh().halfedges()) {
      expect_same_direction(angles.angle(h), angle_from_crossing(h, t, frames), 1e-9);
      expect_same_direction(angles.angle(h), IT::angle_on_input(t, h), 1e-14);
      if(t.coordinates().is_shared(t.mesh().edge(h))) {
        EXPECT_EQ(angles.angle(h), frames.angle(t.input_halfedge(h)));
        EXPECT_EQ(IT::angle_on_input(t, h), frames.angle(t.input_halfedge(h)));
      }
    }
  }
}

TEST(Angular_coordinates, kept_through_flips)
{
  for(const Named_triangulation& named : traced(triangulations()))
    for(unsigned int seed : seeds(3)) {
      Triangulation t = named.triangulation;
      Angles angles(t);
      flip_at_random(t, 40 * t.mesh().number_of_edges(), seed,
                     [&](Halfedge_index h) { angles.after_flip(h); });
      check_kept(angles, t, 1e-9);
    }
}

TEST(Angular_coordinates, errors_do_not_grow)
{
  Triangulation t(random_sphere(100, 3));
  Angles angles(t);
  int flips = 0;
  for(unsigned int seed = 0; seed < 200; ++seed) {
    flip_at_random(t, 1000, seed, [&](Halfedge_index h) {
      angles.after_flip(h);
      ++flips;
    });
    t.recompute_lengths();
  }
  EXPECT_GT(flips, 50000);
  check_kept(angles, t, 1e-10);
}

TEST(Angular_coordinates, visitor_of_make_Delaunay)
{
  for(const Named_triangulation& named : traced(triangulations())) {
    Triangulation t = named.triangulation;
    Angles angles(t);
    IT::make_Delaunay(t, CGAL::parameters::visitor(std::ref(angles)));
    check_kept(angles, t, 1e-9);
  }
}

// Checks that transport in both frames is equal.
void check_tangent_vectors(const Triangulation& t)
{
  const IT::Tangent_frames<> frames(t.intrinsic());
  const Angles angles(t);
  for(Halfedge_index h : t.mesh().halfedges()) {
    const Vertex_index v = t.mesh().source(h), w = t.mesh().target(h);
    const Complex vector = std::polar(2., frames.angle(h));
    const Complex on_input = IT::tangent_vector_across(t, Side::intrinsic, v, vector);
    EXPECT_LT(std::abs(on_input - std::polar(2., angles.angle(h))), 1e-9);
    for(const Complex& back : {IT::tangent_vector_across(t, Side::input, v, on_input),
                               IT::tangent_vector_across(angles, Side::input, v, on_input)})
      EXPECT_LT(std::abs(back - vector), 1e-13);
    if(t.mesh().is_border(v)) {
      EXPECT_EQ(on_input, vector);
    }
    const Complex there =
      IT::tangent_vector_across(t, Side::intrinsic, w, vector * frames.transport(h));
    EXPECT_LT(std::abs(there - on_input * angles.transport(h)), 1e-9);
  }
}

TEST(Angular_coordinates, tangent_vectors_across)
{
  for(Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    check_tangent_vectors(named.triangulation);
    IT::refine(named.triangulation);
    check_tangent_vectors(named.triangulation);
  }
}

// ---- Inserted vertices ----

TEST(Angular_coordinates, of_vectors_between_inserted_vertices_in_the_plane)
{
  std::array<std::size_t, 3> counts{};
  for(const auto& [s, seed] : traced(flat_surfaces(), 10)) {
    const Flat_triangulation flat(s.surface);
    Triangulation t = *flat;
    Plane_vectors vectors(flat, t);
    Random_changes<Plane_vectors> changes(t, seed, vectors);
    changes.change(20 * s.surface.mesh.number_of_edges());
    for(std::size_t k = 0; k < 3; ++k)
      counts[k] += changes.counts[k];
    for(Halfedge_index h : t.mesh().halfedges()) {
      const double angle = angle_in_plane(h, vectors, flat);
      expect_same_direction(IT::angle_on_input(t, h), angle, 1e-9);
      expect_same_direction(vectors.angle(h), angle, 1e-9);
    }
  }
  for(std::size_t count : counts)
    EXPECT_GT(count, 100u);
}

TEST(Angular_coordinates, kept_through_insertions_and_removals)
{
  for(const auto& [named, seed] : traced(triangulations(), 2)) {
    Triangulation t = named.triangulation;
    Angles_only angles(t);
    Random_changes<Angles_only>(t, seed, angles).change(10 * t.mesh().number_of_edges());
    for(Halfedge_index h : t.mesh().halfedges())
      expect_same_direction(angles.angle(h), IT::angle_on_input(t, h), 1e-9);
    t.collect_garbage();
    angles.recompute();
    check_kept(angles, t, 0);
    for(Halfedge_index h : t.mesh().halfedges())
      expect_same_direction(angles.angle(h), IT::angle_on_input(t, h), 1e-14);
    for(Vertex_index v : t.mesh().vertices())
      check_around(v, angles);
    check_by_walking(t, angles);
  }
}

TEST(Angular_coordinates, visitor_of_refine)
{
  for(const Named_triangulation& named : traced(triangulations())) {
    Triangulation t = named.triangulation;
    Angles angles(t);
    IT::refine(t, CGAL::parameters::visitor(std::ref(angles)));
    check_kept(angles, t, 1e-9);
    for(Vertex_index v : t.mesh().vertices())
      check_around(v, angles);
    check_by_walking(t, angles);
  }
}

// Inserted vertices are flat: around a loop of them, transport turns by the curvature inside.
TEST(Angular_coordinates, holonomy_is_curvature)
{
  int loops = 0;
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    Angles angles(t);
    IT::refine(
      t,
      IT::parameters::maximum_circumradius(0.1 * longest_input_edge(t)).visitor(std::ref(angles)));
    for(Vertex_index v : t.mesh().vertices()) {
      if(!is_link_inserted(v, t))
        continue;
      const double curvature = t.is_inserted(v) ? 0 : angles.frames().angle_defect(v);
      expect_same_direction(std::arg(holonomy_around(v, angles)), curvature, 1e-9);
      loops += t.is_inserted(v) ? 0 : 1;
    }
  }
  EXPECT_GT(loops, 50);
}

} // namespace Test_angular_coordinates
