// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/refined_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_parameterizer_3.h>
#include <CGAL/Discrete_conformal_maps/texture_coordinates.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace Test_parameterizer {

using namespace Test_surfaces;
namespace SMP = CGAL::Surface_mesh_parameterization;
using DCM::Flipping;
using Complex = std::complex<double>;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Seam_mesh<Mesh, Mesh::Property_map<Edge_index, bool>,
                        Mesh::Property_map<Vertex_index, bool>>
  Seam_mesh;

// ---- Meshes ----

// Returns equilateral triangles over a parallelogram, slightly bent: Delaunay, without obtuse
// angles.
Mesh bent_triangles(std::size_t n)
{
  const auto place = [](double x, double y) {
    return Point(x + y / 2, std::sqrt(0.75) * y, 0.05 * std::sin(x) * std::cos(y));
  };
  // The diagonals of grid() lead from (0, 0) to (1, 1). Diagonals of a rhombus of two equilateral
  // triangles do not.
  Mesh mesh = grid(n, n, [&](double x, double y) { return place(double(n) - x, y); });
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  return mesh;
}

// Returns this mesh with two triangles that are not Delaunay.
Mesh with_bad_edge(Mesh mesh)
{
  for(Edge_index e : mesh.edges())
    if(!mesh.is_border(mesh.vertex(e, 0)) && !mesh.is_border(mesh.vertex(e, 1))) {
      IT::flip_edge(mesh.halfedge(e), mesh);
      break;
    }
  return mesh;
}

template <typename Graph>
typename boost::graph_traits<Graph>::halfedge_descriptor border_of(const Graph& g)
{
  for(auto h : halfedges(g))
    if(CGAL::is_border(h, g))
      return h;
  return boost::graph_traits<Graph>::null_halfedge();
}

// ---- Parameterizing ----

template <typename Graph>
struct Parameterization
{
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, Point_2> uv;
  SMP::Error_code code;
  bool is_one_to_one = false;
};

template <typename Graph>
Parameterization<Graph> parameterize(Graph& g, Flipping flipping = Flipping::to_Delaunay)
{
  Parameterization<Graph> result;
  boost::associative_property_map<decltype(result.uv)> map(result.uv);
  DCM::Discrete_conformal_parameterizer_3<Graph> parameterizer(flipping);
  result.code = SMP::parameterize(g, parameterizer, border_of(g), map);
  if(result.code == SMP::OK)
    result.is_one_to_one = parameterizer.is_one_to_one_mapping(g, border_of(g), map);
  return result;
}

// Checks that all distances of vertices are the distances in the plane of `flatten()`.
void check_isometric(const Parameterization<Mesh>& p, const Mesh& mesh,
                     const Planar_conformal_map& map)
{
  const auto image = [&](Vertex_index v) { return map(corner(mesh_A(map), v)); };
  for(Vertex_index v : mesh.vertices())
    for(Vertex_index w : mesh.vertices())
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p.uv.at(v), p.uv.at(w))),
                  std::abs(image(v) - image(w)), 1e-12);
}

// Checks discrete conformal equivalence. Each triangle has sides in the plane of length l e^((u_i +
// u_j) / 2), which determine u at its corners. They must agree in all triangles, and vanish on the
// boundary.
template <typename Graph>
void check_conformal(const Parameterization<Graph>& p, const Graph& g)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  const auto log_ratio = [&](Vertex v, Vertex w) {
    const auto point = get(CGAL::vertex_point, g);
    return std::log(CGAL::squared_distance(p.uv.at(v), p.uv.at(w)) /
                    CGAL::squared_distance(get(point, v), get(point, w)));
  };
  std::map<Vertex, double> u;
  for(auto h : halfedges(g)) {
    if(CGAL::is_border(h, g))
      continue;
    const Vertex i = target(h, g), j = target(next(h, g), g), k = source(h, g);
    const double u_i = (log_ratio(i, j) + log_ratio(i, k) - log_ratio(j, k)) / 2;
    const auto [entry, is_new] = u.emplace(i, u_i);
    EXPECT_NEAR(entry->second, u_i, 1e-9);
    EXPECT_GT(CGAL::orientation(p.uv.at(k), p.uv.at(i), p.uv.at(j)), 0);
  }
  for(auto h : halfedges(g))
    if(CGAL::is_border(h, g)) {
      EXPECT_NEAR(u.at(target(h, g)), 0, 1e-9);
    }
}

// ---- Parameterizer_3 ----

TEST(Parameterizer, is_isometric_to_flatten)
{
  Mesh mesh = bent_triangles(6);
  const Parameterization<Mesh> p = parameterize(mesh);
  ASSERT_EQ(p.code, SMP::OK);
  EXPECT_TRUE(p.is_one_to_one);
  check_isometric(p, mesh, DCM::flatten(mesh));
  check_conformal(p, mesh);
}

TEST(Parameterizer, takes_one_component)
{
  Mesh mesh = random_sphere(20, 1);
  mesh += bent_triangles(4);
  const Parameterization<Mesh> p = parameterize(mesh);
  ASSERT_EQ(p.code, SMP::OK);
  EXPECT_EQ(p.uv.size(), bent_triangles(4).number_of_vertices());
  EXPECT_TRUE(p.is_one_to_one);
}

TEST(Parameterizer, takes_other_graphs)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Polyhedron polyhedron;
  CGAL::copy_face_graph(bent_triangles(4), polyhedron);
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, Point_2> uv;
  boost::associative_property_map<decltype(uv)> map(uv);
  EXPECT_EQ(SMP::parameterize(polyhedron, DCM::Discrete_conformal_parameterizer_3<Polyhedron>(),
                              border_of(polyhedron), map),
            SMP::OK);
  EXPECT_EQ(uv.size(), polyhedron.size_of_vertices());
}

// A regular tetrahedron, cut open along the edges of a vertex, is a triangle with sides twice as
// long.
TEST(Parameterizer, unfolds_a_tetrahedron)
{
  Mesh mesh;
  std::vector<Vertex_index> v;
  for(const Point& p : {Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)})
    v.push_back(mesh.add_vertex(p));
  for(const auto& [i, j, k] : {std::array{0u, 1u, 2u}, {0u, 2u, 3u}, {0u, 3u, 1u}, {1u, 3u, 2u}})
    mesh.add_face(v[i], v[j], v[k]);
  auto edges = mesh.add_property_map<Edge_index, bool>("e:seam", false).first;
  auto vertices = mesh.add_property_map<Vertex_index, bool>("v:seam", false).first;
  Seam_mesh cut(mesh, edges, vertices);
  for(std::size_t i = 1; i < 4; ++i)
    cut.add_seam(v[0], v[i]);
  const auto bhd = CGAL::opposite(Seam_mesh::halfedge_descriptor(mesh.halfedge(v[0], v[1])), cut);
  Parameterization<Seam_mesh> p;
  p.code = SMP::parameterize(cut, DCM::Discrete_conformal_parameterizer_3<Seam_mesh>(), bhd,
                             boost::associative_property_map<decltype(p.uv)>(p.uv));
  ASSERT_EQ(p.code, SMP::OK);
  ASSERT_EQ(p.uv.size(), 6u);
  std::vector<Point_2> apexes;
  for(const auto& [vertex, z] : p.uv)
    if(mesh.target(vertex) == v[0])
      apexes.push_back(z);
  ASSERT_EQ(apexes.size(), 3u);
  for(std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(CGAL::squared_distance(apexes[i], apexes[(i + 1) % 3]), 32, 1e-12);
}

// An octahedron with rounded sides, cut open along a path of edges, is not Delaunay everywhere.
TEST(Parameterizer, opens_a_seam_mesh)
{
  Mesh mesh = unit_sphere(3);
  auto edges = mesh.add_property_map<Edge_index, bool>("e:seam", false).first;
  auto vertices = mesh.add_property_map<Vertex_index, bool>("v:seam", false).first;
  Seam_mesh cut(mesh, edges, vertices);
  Halfedge_index h = *mesh.halfedges().begin(), first = h;
  for(int i = 0; i < 5; ++i) {
    cut.add_seam(mesh.source(h), mesh.target(h));
    h = mesh.next(mesh.opposite(mesh.next(mesh.opposite(mesh.next(h)))));
  }
  const auto bhd = CGAL::opposite(Seam_mesh::halfedge_descriptor(first), cut);
  ASSERT_TRUE(CGAL::is_border(bhd, cut));
  Parameterization<Seam_mesh> p;
  const boost::associative_property_map<decltype(p.uv)> map(p.uv);
  const auto code_with = [&](Flipping flipping) {
    return SMP::parameterize(cut, DCM::Discrete_conformal_parameterizer_3<Seam_mesh>(flipping), bhd,
                             map);
  };
  EXPECT_EQ(code_with(Flipping::to_Delaunay), SMP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_TRUE(p.uv.empty());
  ASSERT_EQ(code_with(Flipping::none), SMP::OK);
  EXPECT_EQ(p.uv.size(), mesh.number_of_vertices() + 4);
  check_conformal(p, cut);
}

TEST(Parameterizer, says_when_an_edge_has_to_be_flipped)
{
  Mesh bad = with_bad_edge(bent_triangles(6));
  const Parameterization<Mesh> p = parameterize(bad);
  EXPECT_EQ(p.code, SMP::ERROR_NO_1_TO_1_MAPPING);
  EXPECT_TRUE(p.uv.empty());
  // The lengths result only from Ptolemy flips: the mesh is Delaunay up to the scale factors.
  Mesh steep = perturbed(
    grid(8, 8, [](double x, double y) { return Point(x, y, 3 * std::sin(x) * std::sin(y)); }), 0.1,
    2);
  const Planar_conformal_map map = DCM::flatten(steep);
  EXPECT_GT(map.number_of_flips(Layer::C), 0u);
  EXPECT_EQ(parameterize(steep).code, SMP::ERROR_NO_1_TO_1_MAPPING);
}

TEST(Parameterizer, needs_no_flip_in_a_fixed_triangulation)
{
  Mesh bad = with_bad_edge(bent_triangles(6));
  const Parameterization<Mesh> p = parameterize(bad, Flipping::none);
  ASSERT_EQ(p.code, SMP::OK);
  check_conformal(p, bad);
}

TEST(Parameterizer, says_what_is_wrong)
{
  Mesh annulus = bent_triangles(6);
  CGAL::Euler::remove_face(annulus.halfedge(Face_index(30)), annulus);
  EXPECT_EQ(parameterize(annulus).code, SMP::ERROR_NO_TOPOLOGICAL_DISC);

  Mesh quadrangle;
  std::vector<Vertex_index> v;
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    v.push_back(quadrangle.add_vertex(p));
  quadrangle.add_face(v);
  EXPECT_EQ(parameterize(quadrangle).code, SMP::ERROR_NON_TRIANGULAR_MESH);

  Mesh point_like = bent_triangles(3);
  for(Vertex_index x : point_like.vertices())
    point_like.point(x) = Point(1, 1, 1);
  EXPECT_EQ(parameterize(point_like).code, SMP::ERROR_WRONG_PARAMETER);
}

// ---- Texture coordinates ----

TEST(Texture_coordinates, are_images_of_corners)
{
  const Mesh mesh = bent_triangles(5);
  const Planar_conformal_map map = DCM::flatten(mesh);
  ASSERT_TRUE(DCM::has_whole_faces(map));
  std::map<Halfedge_index, Complex> uv;
  std::map<Halfedge_index, std::array<double, 3>> uvw;
  DCM::texture_coordinates(map, mesh, boost::make_assoc_property_map(uv));
  DCM::homogeneous_texture_coordinates(map, mesh, boost::make_assoc_property_map(uvw));
  EXPECT_EQ(uv.size(), 3 * mesh.number_of_faces());
  CGAL::Random random(5);
  for(Face_index f : mesh.faces()) {
    const std::array<double, 3> w = random_location(mesh_A(map), random).second;
    std::array<double, 3> z{0, 0, 0};
    std::size_t s = 0;
    for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      Location p{f, {0, 0, 0}};
      p.second[(s + 1) % 3] = 1; // weights belong to sources
      EXPECT_LT(std::abs(uv.at(h) - map(p)), 1e-12);
      for(std::size_t i = 0; i < 3; ++i)
        z[i] += w[(s + 1) % 3] * uvw.at(h)[i];
      ++s;
    }
    EXPECT_LT(std::abs(Complex(z[0], z[1]) / z[2] - map({f, w})), 1e-12);
  }
}

// Corners at seams have several positions. With few vertices, loops and parallel edges occur.
TEST(Texture_coordinates, of_a_surface_with_seams)
{
  for(const auto& [m, n] : {std::pair(5, 4), {1, 1}, {2, 1}}) {
    const Flat_surface torus = flat_torus(m, n, 1);
    Triangulation t(torus.mesh, length_parameter(torus.lengths()));
    IT::make_Delaunay(t);
    const Planar_conformal_map map = flatten(t.mesh(), lengths_of(t));
    ASSERT_TRUE(DCM::has_whole_faces(map));
    std::vector<Point_2> uv(t.mesh().number_of_halfedges());
    DCM::texture_coordinates(
      map, t.mesh(),
      boost::make_iterator_property_map(uv.begin(), get(boost::halfedge_index, t.mesh())));
    for(Halfedge_index h : t.mesh().halfedges())
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(uv[h], uv[t.mesh().prev(h)])),
                  t.length(t.mesh().edge(h)), 1e-11 * t.length(t.mesh().edge(h)));
  }
}

TEST(Texture_coordinates, are_refused_where_they_say_too_little)
{
  const auto write = [](const Planar_conformal_map& map, const auto& g) {
    std::map<Halfedge_index, Complex> uv;
    EXPECT_THROW(DCM::texture_coordinates(map, g, boost::make_assoc_property_map(uv)),
                 DCM::No_texture_coordinates);
    EXPECT_TRUE(uv.empty());
  };
  const Mesh bad = with_bad_edge(bent_triangles(6));
  const Planar_conformal_map cut = DCM::flatten(bad);
  EXPECT_FALSE(DCM::has_whole_faces(cut));
  write(cut, bad);

  const Mesh simplex = tetrahedron();
  Conditions condition = as_log_scales({0, 0, 0, 0});
  condition[0] = Vertex_condition::curvature(-1.5 * pi);
  const Planar_conformal_map flat = DCM::flatten(
    simplex, DCM::parameters::flipping(Flipping::none).vertex_condition_map(as_map(condition)));
  EXPECT_FALSE(flat.is_laid_out());
  write(flat, simplex);
}

} // namespace Test_parameterizer
