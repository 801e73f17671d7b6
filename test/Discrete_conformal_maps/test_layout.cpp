// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Polyhedron_3.h>
#include <boost/pending/disjoint_sets.hpp>

namespace Test_layout {

using namespace Test_surfaces;

// ---- Surfaces ----

struct Named_map
{
  std::string name;
  Mesh mesh;
  Planar_conformal_map map;
};

std::vector<Named_mesh> disks()
{
  const auto hill = [](double x, double y) { return Point(x, y, std::sin(x) * std::cos(y)); };
  return {{"one triangle", make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 3, 1}}, {{0, 1, 2}})},
          {"hill", perturbed(grid(8, 7, hill), 0.3, 1)},
          {"polygon", planar_mesh(random_points(25, 1000, 5))},
          {"sphere with a hole", punctured(random_sphere(40, 6), {0})}};
}

std::vector<Named_mesh> closed_meshes()
{
  std::vector<Named_mesh> result;
  for(const Named_mesh& m : meshes())
    if(CGAL::is_closed(m.mesh))
      result.push_back(m);
  result.push_back({"larger sphere", random_sphere(400, 9)});
  for(int genus : {0, 1, 2, 3, 4})
    result.push_back({"genus " + std::to_string(genus), plate_with_holes(genus)});
  return result;
}

std::vector<Named_map> maps()
{
  std::vector<Named_map> result;
  for(const auto& list : {meshes(), disks(), closed_meshes()})
    for(const Named_mesh& m : list)
      result.push_back({m.name, m.mesh, DCM::flatten(m.mesh)});
  result.push_back({"five components", five_components(), DCM::flatten(five_components())});
  return result;
}

Planar_conformal_map flat_disk(const Mesh& mesh) // without cones
{
  return DCM::flatten(mesh, DCM::parameters::cones(DCM::Cones::none));
}

// ---- Seams ----

struct Seams
{
  explicit Seams(const Planar_conformal_map& map) : degree(mesh_C(map).number_of_vertices(), 0)
  {
    const Delta_complex& mesh = mesh_C(map);
    boost::disjoint_sets_with_storage<> sets(mesh.number_of_vertices());
    for(Vertex_index v : mesh.vertices())
      sets.make_set(v.idx());
    for(Edge_index e : mesh.edges())
      if(map.is_seam(e)) {
        ++edges;
        for(unsigned int i : {0u, 1u}) {
          vertices += degree[mesh.vertex(e, i)]++ == 0;
        }
        sets.union_set(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
      }
    for(Vertex_index v : mesh.vertices())
      pieces += degree[v] > 0 && sets.find_set(v.idx()) == v.idx();
  }

  std::vector<int> degree;
  int edges = 0, vertices = 0, pieces = 0;
};

// ---- Points ----

double doubled_area(const std::vector<Complex>& corners)
{
  double result = 0;
  for(std::size_t i = 1; i + 1 < corners.size(); ++i)
    result += (std::conj(corners[i] - corners[0]) * (corners[i + 1] - corners[0])).imag();
  return result;
}

struct Sample
{
  Location on_A;
  Complex expected;
};

// Returns the area relative to the area of the face of T_1.
double area_on_A(const Planar_conformal_map& map, Face_index f)
{
  const auto& s = map.subdivision();
  std::vector<Complex> corners;
  for(Halfedge_index h : CGAL::halfedges_around_face(s.mesh().halfedge(f), s.mesh())) {
    const Location p =
      on_face(map, s.parent_face(Layer::A, f),
              IT::face_location(s.place(Layer::A, s.mesh().target(h)), s.mesh(Layer::A)));
    corners.emplace_back(p.second[1], p.second[2]);
  }
  return doubled_area(corners);
}

// Returns a point of a face of the subdivision with its image, linear between the homogeneous
// coordinates of the corners.
Sample random_point(const Planar_conformal_map& map, Face_index f, CGAL::Random& random)
{
  const auto& s = map.subdivision();
  Sample result{{s.parent_face(Layer::A, f), {0, 0, 0}}, {0, 0}};
  double sum = 0, weight = 0;
  for(Halfedge_index h : CGAL::halfedges_around_face(s.mesh().halfedge(f), s.mesh())) {
    const double t = random.get_double(0.01, 1);
    const Location p =
      on_face(map, result.on_A.first,
              IT::face_location(s.place(Layer::A, s.mesh().target(h)), s.mesh(Layer::A)));
    const auto z = map.homogeneous_coordinates(s.location(Layer::C, h));
    for(std::size_t i = 0; i < 3; ++i)
      result.on_A.second[i] += t * p.second[i];
    result.expected += t * Complex(z[0], z[1]);
    weight += t * z[2];
    sum += t;
  }
  for(double& x : result.on_A.second)
    x /= sum;
  result.expected /= weight;
  return result;
}

// Returns the position on the face beyond an edge of T_1.
Location beyond_edge(const Planar_conformal_map& map, const Location& p, Halfedge_index h)
{
  return on_face(map, mesh_A(map).face(mesh_A(map).opposite(h)), p);
}

Location on_edge(const Delta_complex& mesh, Halfedge_index h, double t)
{
  Location result{mesh.face(h), {0, 0, 0}};
  std::size_t s = 0;
  for(Halfedge_index x : CGAL::halfedges_around_face(mesh.halfedge(mesh.face(h)), mesh)) {
    result.second[s] = x == h ? 1 - t : mesh.prev(x) == h ? t : 0;
    ++s;
  }
  return result;
}

// ---- Isometries ----

// Represents the motion of the plane of `place` to the plane of the image, from two points close to
// each other.
struct Rigid_motion
{
  Complex from, to, turn;
  Complex back(const Complex& z) const { return from + (z - to) / turn; }
};

Rigid_motion motion(const Planar_conformal_map& map, const Flat_places& places)
{
  CGAL::Random random(3);
  for(;;) { // until no seam is between
    const Location p = random_front_location(map, random);
    Location q = p;
    for(double& x : q.second)
      x += 1e-3 * (1. / 3 - x);
    const Complex step = places.place(q) - places.place(p), image = map(q) - map(p);
    if(std::abs(std::abs(image / step) - 1) < 1e-9)
      return {places.place(p), map(p), image / std::abs(image) * std::abs(step) / step};
  }
}

void check_isometry(const Flat_surface& surface)
{
  const Planar_conformal_map map = flatten(surface.mesh, surface.lengths());
  const Flat_triangulation flat(surface);
  const Flat_places places(Side::input, flat);
  const Rigid_motion m = motion(map, places);
  check_layout(map);
  CGAL::Random random(4);
  for(int i = 0; i < 1000; ++i) {
    const Location p = random_front_location(map, random);
    // The direction is known to 1e-12 over 1e-3 of an edge.
    EXPECT_LT(places.distance(places.place(p), m.back(map(p))), 1e-8 * size_of(map)) << i;
  }
}

// ---- Layout ----

TEST(Layout, faces_have_their_lengths_and_fit_together)
{
  for(const Named_map& m : traced(maps()))
    check_layout(m.map);
}

TEST(Layout, is_Delaunay)
{
  for(const Named_map& m : traced(maps())) {
    const Delta_complex& mesh = mesh_C(m.map);
    const std::vector<double> length = scaled_lengths(m.map);
    for(Edge_index e : mesh.edges()) {
      if(mesh.is_border(e)) // the mirror image of one that is not
        continue;
      const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
      EXPECT_LT(angle_at(mesh.prev(h), mesh, length) + angle_at(mesh.prev(o), mesh, length),
                pi + 1e-9)
        << e;
    }
  }
}

TEST(Layout, disk_without_cones_has_no_seam)
{
  for(const Named_mesh& d : traced(disks())) {
    const Planar_conformal_map map = flat_disk(d.mesh);
    EXPECT_TRUE(map.cones().empty());
    EXPECT_TRUE(has_no_seam(map));
    check_layout(map);
  }
}

// The remaining surface is a disk: the removed part has the Euler characteristic of the surface
// minus one.
TEST(Layout, seams_cut_a_closed_surface_to_a_disk)
{
  for(const Named_mesh& m : traced(closed_meshes()))
    for(const double bound : traced({0.5, 5.})) {
      const Planar_conformal_map map =
        DCM::flatten(m.mesh, DCM::parameters::maximum_log_scale(bound));
      const Seams seams(map);
      EXPECT_EQ(seams.vertices - seams.edges, Euler_characteristic(mesh_C(map)) - 1);
      EXPECT_EQ(seams.pieces, 1);
      const std::set<Vertex_index> cones(map.cones().begin(), map.cones().end());
      EXPECT_EQ(cones.size(), map.cones().size());
      for(Vertex_index v : mesh_C(map).vertices())
        EXPECT_GE(seams.degree[v], cones.count(v) > 0 ? 1 : seams.degree[v] == 1 ? 2 : 0) << v;
    }
}

TEST(Layout, seams_join_prescribed_cones_only)
{
  const Mesh sphere = random_sphere(200, 2);
  for(const std::size_t k : std::array<std::size_t, 3>{3, 4, 10}) {
    Conditions condition(200);
    for(std::size_t i = 0; i < k; ++i)
      condition[17 * i] = Vertex_condition::curvature(4 * pi / double(k));
    const Planar_conformal_map map = flatten(Triangulation(sphere), condition);
    const Seams seams(map);
    EXPECT_EQ(seams.vertices - seams.edges, 1);
    EXPECT_EQ(seams.pieces, 1);
    for(std::size_t v = 0; v < condition.size(); ++v)
      EXPECT_GE(seams.degree[v], condition[v].value != 0 ? 1 : seams.degree[v] == 1 ? 2 : 0) << v;
    check_layout(map);
  }
}

TEST(Layout, faces_of_the_subdivision_are_not_turned_over)
{
  for(const Named_map& m : traced(maps())) {
    const auto& s = m.map.subdivision();
    const double size = size_of(m.map);
    for(Face_index f : s.mesh().faces()) {
      if(!m.map.is_original(s.parent_face(Layer::A, f)))
        continue;
      std::vector<Complex> corners;
      for(Halfedge_index h : CGAL::halfedges_around_face(s.mesh().halfedge(f), s.mesh())) {
        const auto z = m.map.homogeneous_coordinates(s.location(Layer::C, h));
        EXPECT_GT(z[2], 0);
        corners.push_back(Complex(z[0], z[1]) / z[2]);
      }
      EXPECT_GT(doubled_area(corners), -1e-14 * size * size) << f;
    }
  }
}

// ---- The map ----

TEST(Planar_conformal_map, is_an_isometry_of_flat_surfaces)
{
  for(unsigned int seed : {1u, 2u})
    check_isometry(flat_torus(4, 3, seed));
  check_isometry(flat_grid(6, 5, 2));
  check_isometry(flat_polygon(random_points(25, 1000, 5)));
  check_isometry(flat_polygon(random_points(200, 10000, 6)));
  check_isometry(flat_cylinder(4, 0));
  check_isometry(flat_cylinder(3, 2));
}

TEST(Planar_conformal_map, is_linear_on_the_subdivision)
{
  for(const Named_map& m : traced(maps())) {
    CGAL::Random random(5);
    const auto& s = m.map.subdivision();
    const double size = size_of(m.map);
    for(Face_index f : s.mesh().faces())
      // In a sliver, a point may count as a point of the next face, possibly beyond a seam.
      if(m.map.is_original(s.parent_face(Layer::A, f)) && area_on_A(m.map, f) > 1e-12) {
        const Sample sample = random_point(m.map, f, random);
        EXPECT_LT(std::abs(m.map(sample.on_A) - sample.expected), 1e-9 * size) << f;
      }
  }
}

TEST(Planar_conformal_map, is_continuous_across_edges_of_a_disk)
{
  for(const Named_mesh& d : traced(disks())) {
    const Planar_conformal_map map = flat_disk(d.mesh);
    ASSERT_TRUE(has_no_seam(map));
    const Delta_complex& mesh = mesh_A(map);
    for(Edge_index e : mesh.edges()) {
      const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
      if(map.is_original(mesh.face(h)) && map.is_original(mesh.face(o)))
        for(const double t : {0.01, 0.3, 0.5, 0.99}) {
          const Location p = on_edge(mesh, h, t);
          EXPECT_LT(std::abs(map(p) - map(beyond_edge(map, p, h))), 1e-9 * size_of(map)) << e;
        }
    }
  }
}

TEST(Planar_conformal_map, takes_vertices_to_vertices)
{
  for(const Named_mesh& d : traced(disks())) {
    const Planar_conformal_map map = flat_disk(d.mesh);
    const Used_faces is_used = used_faces(map);
    for(Halfedge_index h : mesh_C(map).halfedges())
      if(const Vertex_index v = mesh_C(map).source(h);
         is_used[mesh_C(map).face(h)] && v.idx() < d.mesh.number_of_vertices()) {
        EXPECT_LT(std::abs(map(corner(mesh_A(map), v)) - map.position(h)), 1e-12 * size_of(map));
      }
  }
}

// If all three triangulations have a common face, the map is the projective map of two triangles
// that maps one circumcircle to the other. It has the weights exp(-u) (Springborn, Schroeder,
// Pinkall 2008).
TEST(Planar_conformal_map, is_projective_with_the_circumcircles)
{
  const Mesh mesh = bipyramid(12, 0.5);
  const Triangulation t(mesh);
  Conditions condition(14);
  for(std::size_t v = 0; v < 12; ++v)
    condition[v] = Vertex_condition::curvature(pi / 3);
  const Planar_conformal_map map = flatten(t, condition);
  const Delta_complex& a = mesh_A(map);
  // With vertices on the ring, the foot of the bisector of a face is mapped to the foot in its
  // image.
  for(Face_index f : a.faces()) {
    std::vector<Complex> place;
    for(Halfedge_index h : CGAL::halfedges_around_face(a.halfedge(f), a))
      place.push_back(map.position(h));
    std::size_t apex = 0, s = 0;
    for(Halfedge_index h : CGAL::halfedges_around_face(a.halfedge(f), a)) {
      ASSERT_EQ(mesh_C(map).source(h), a.source(h));
      apex = a.source(h) >= 12u ? s : apex;
      ++s;
    }
    const Complex z = place[apex], x = place[(apex + 1) % 3], y = place[(apex + 2) % 3];
    // Along the bisector, the point with height h of the old triangle is mapped to a point with the
    // same cross ratio. The other points are the apex, the foot, and the second intersection with
    // the circumcircle.
    const double outgoing = std::hypot(1, 0.5), ring = 2 * std::sin(pi / 12);
    const double old_foot = std::sqrt(outgoing * outgoing - ring * ring / 4),
                 old_end = outgoing * outgoing / old_foot;
    const double new_foot = std::abs((x + y) / 2. - z), new_end = std::norm(x - z) / new_foot;
    const auto cross_ratio = [](double p, double foot, double end) {
      return (p / (p - end)) / (foot / (foot - end));
    };
    for(const double h : {0.2, 0.5, 0.9}) {
      Location p{f, {(1 - h) / 2, (1 - h) / 2, (1 - h) / 2}};
      p.second[apex] = h;
      const double distance = std::abs(map(p) - z);
      EXPECT_NEAR(cross_ratio(distance, new_foot, new_end),
                  cross_ratio((1 - h) * old_foot, old_foot, old_end), 1e-12);
    }
  }
}

// ---- Two triangulations of one surface ----

TEST(Planar_conformal_map, does_not_depend_on_the_triangulation)
{
  for(const Named_mesh& d : traced(disks())) {
    Triangulation t(d.mesh);
    flip_at_random(t, 20 * t.mesh().number_of_edges(), 3);
    const Planar_conformal_map one = flat_disk(d.mesh),
                               two = flatten(t, default_conditions(t.mesh()));
    const Correspondence correspondence(t);
    CGAL::Random random(7);
    std::vector<std::pair<Complex, Complex>> images;
    for(int i = 0; i < 500; ++i) {
      const Location p = random_location(t.input_mesh(), random);
      images.emplace_back(one(p), two(IT::point_across(correspondence, Side::input, p)));
    }
    const auto far = std::max_element(images.begin(), images.end(), [&](auto& a, auto& b) {
      return std::abs(a.first - images[0].first) < std::abs(b.first - images[0].first);
    });
    const Complex turn = (far->second - images[0].second) / (far->first - images[0].first);
    EXPECT_NEAR(std::abs(turn), 1, 1e-9);
    for(const auto& [p, q] : images)
      EXPECT_LT(std::abs(images[0].second + turn * (p - images[0].first) - q), 1e-8 * size_of(one));
  }
}

TEST(Planar_conformal_map, takes_other_graphs)
{
  const Mesh mesh = random_sphere(40, 1);
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  const auto condition = [&](const auto& g) {
    using Vertex = typename boost::graph_traits<std::decay_t<decltype(g)>>::vertex_descriptor;
    return boost::make_function_property_map<Vertex>([&g](Vertex v) {
      return get(CGAL::vertex_point, g, v).x() > 0.5 ? Vertex_condition::log_scale(0)
                                                     : Vertex_condition::curvature(0.01);
    });
  };
  const Planar_conformal_map one = DCM::flatten(
                               mesh, DCM::parameters::vertex_condition_map(condition(mesh))),
                             two = DCM::flatten(polyhedron, DCM::parameters::vertex_condition_map(
                                                              condition(polyhedron)));
  std::map<Point, std::size_t> in_mesh; // the copy has another order
  for(const auto v : mesh.vertices())
    in_mesh.emplace(mesh.point(v), in_mesh.size());
  std::size_t number = 0;
  for(const auto w : vertices(polyhedron))
    EXPECT_NEAR(log_scale(one, in_mesh.at(w->point())), log_scale(two, number++), 1e-12);
}

} // namespace Test_layout
