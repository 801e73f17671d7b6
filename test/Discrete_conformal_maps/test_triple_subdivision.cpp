// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/data_meshes.h"
#include "../Intrinsic_triangulations/known_surfaces.h"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <boost/property_map/property_map.hpp>

namespace Test_triple_subdivision {

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
using DCM::Layer;
using Subdivision = DCM::Triple_subdivision<>;
using Barycentric = std::array<double, 3>;

constexpr std::array<Layer, 3> layers{Layer::A, Layer::B, Layer::C};

// ---- Three triangulations of one surface ----

Triangulation next_triangulation(const Triangulation& t)
{
  std::vector<double> lengths;
  for(Edge_index e : t.mesh().edges())
    lengths.push_back(t.length(e));
  return triangulation(t.mesh(), lengths);
}

struct Three
{
  explicit Three(const Triangulation& first) : ab(first), bc(next_triangulation(first)) {}

  const Delta_complex& mesh(Layer layer) const
  {
    return layer == Layer::A ? ab.input_mesh() : layer == Layer::B ? ab.mesh() : bc.mesh();
  }
  double length(Layer layer, Edge_index e) const
  {
    return layer == Layer::A ? ab.input_length(e) : layer == Layer::B ? ab.length(e) : bc.length(e);
  }
  Subdivision subdivision() const { return {Correspondence(ab), Correspondence(bc)}; }

  Triangulation ab, bc;
};

struct Named_three
{
  std::string name;
  Three three;
};

std::vector<Named_three> all_threes()
{
  std::vector<Named_three> result;
  for(const Named_triangulation& t : triangulations()) {
    result.push_back({t.name + ", B = C", Three(t.triangulation)});
    result.push_back({t.name + ", C Delaunay", Three(t.triangulation)});
    IT::make_Delaunay(result.back().three.bc);
    result.push_back({t.name + ", C flipped", Three(t.triangulation)});
    flip_at_random(result.back().three.bc, 10 * t.triangulation.mesh().number_of_edges(), 99);
  }
  return result;
}

// ---- Numbers ----

// Checks that the pieces of an edge are a path from one of its ends to the other, with only
// crossings between.
void check_pieces(Layer layer, const Subdivision& s, const Three& three)
{
  std::vector<std::vector<Vertex_index>> ends(three.mesh(layer).number_of_edges());
  std::set<Edge_index> in_B;
  for(Edge_index e : s.mesh().edges())
    if(const Edge_index parent = s.parent_edge(layer, e); parent.is_valid())
      for(unsigned int i = 0; i < 2; ++i) {
        ends[parent].push_back(s.mesh().vertex(e, i));
        if(s.parent_edge(Layer::B, e).is_valid())
          in_B.insert(parent);
      }
  for(Edge_index e : three.mesh(layer).edges()) {
    std::vector<Vertex_index> input;
    std::multiset<Vertex_index> crossings;
    for(Vertex_index v : ends[e])
      if(s.is_vertex(Layer::A, v))
        input.push_back(v);
      else
        crossings.insert(v);
    std::sort(input.begin(), input.end());
    const auto expected =
      std::minmax({three.mesh(layer).vertex(e, 0), three.mesh(layer).vertex(e, 1)});
    EXPECT_EQ(input, (std::vector<Vertex_index>{expected.first, expected.second}));
    for(Vertex_index v : crossings) {
      EXPECT_EQ(crossings.count(v), 2u);
      EXPECT_TRUE(s.is_crossing(layer, v) || in_B.count(e) > 0);
    }
  }
}

void check_numbers(const Subdivision& s, const Three& three)
{
  EXPECT_TRUE(s.mesh().is_valid(true));
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(three.mesh(Layer::A)));
  EXPECT_EQ(number_of_border_edges(s.mesh()), number_of_border_edges(three.mesh(Layer::A)));
  for(Face_index f : s.mesh().faces())
    EXPECT_GE(sides_of(f, s).size(), 3u);
  for(Layer layer : layers)
    check_pieces(layer, s, three);
  for(Edge_index e : s.mesh().edges())
    EXPECT_TRUE(s.parent_edge(Layer::A, e).is_valid() || s.parent_edge(Layer::B, e).is_valid() ||
                s.parent_edge(Layer::C, e).is_valid());
  for(Vertex_index v : s.mesh().vertices())
    if(!s.is_vertex(Layer::A, v)) {
      EXPECT_EQ(s.mesh().degree(v), 4u);
    }
}

// ---- Lengths and areas, seen in C ----

void check_measures(const Subdivision& s, const Three& three, double tolerance)
{
  const Flat_faces faces(Side::intrinsic, three.bc);
  const Real size = faces.longest_edge();
  std::array<std::vector<Real>, 3> area_of_face, length_of_edge;
  for(std::size_t i = 0; i < 3; ++i) {
    area_of_face[i].resize(three.mesh(layers[i]).number_of_faces());
    length_of_edge[i].resize(three.mesh(layers[i]).number_of_edges());
  }
  for(Face_index f : s.mesh().faces()) {
    const auto halfedges = sides_of(f, s);
    const Face_index parent = s.parent_face(Layer::C, f);
    Polygon polygon; // corner k is the target of halfedge k
    for(Halfedge_index h : halfedges) {
      const auto& p = s.location(Layer::C, h);
      ASSERT_EQ(p.first, parent);
      ASSERT_NEAR(p.second[0] + p.second[1] + p.second[2], 1, 1e-15);
      polygon.push_back(faces.place(faces.sides(parent)[0], p));
    }
    EXPECT_GT(area(polygon), -1e-13 * size * size) << f;
    for(std::size_t i = 0; i < 3; ++i)
      area_of_face[i][s.parent_face(layers[i], f)] += area(polygon);
    for(std::size_t k = 0; k < halfedges.size(); ++k) {
      const std::size_t before = (k + halfedges.size() - 1) % halfedges.size();
      const Edge_index e = s.mesh().edge(halfedges[k]);
      for(std::size_t i = 0; i < 3; ++i)
        if(const Edge_index p = s.parent_edge(layers[i], e); p.is_valid())
          length_of_edge[i][p] +=
            norm(polygon[k] - polygon[before]) / (s.mesh().is_border(e) ? 1 : 2);
    }
  }
  for(std::size_t i = 0; i < 3; ++i) {
    for(Face_index f : three.mesh(layers[i]).faces()) {
      std::array<double, 3> l;
      std::size_t k = 0;
      for(Halfedge_index h :
          CGAL::halfedges_around_face(three.mesh(layers[i]).halfedge(f), three.mesh(layers[i])))
        l[k++] = three.length(layers[i], Edge_index(h));
      const double expected = std::sqrt(IT::squared_quadrupled_area(l[0], l[1], l[2])) / 4;
      EXPECT_NEAR(double(area_of_face[i][f]) / expected, 1, tolerance) << i << " " << f;
    }
    for(Edge_index e : three.mesh(layers[i]).edges())
      EXPECT_NEAR(double(length_of_edge[i][e]) / three.length(layers[i], e), 1, tolerance)
        << i << " " << e;
  }
}

// ---- In the plane ----

struct Flat_three
{
  explicit Flat_three(const Flat_surface& surface) : ab(surface) {}

  Flat_triangulation next() const
  {
    Flat_surface b = ab.surface();
    b.mesh = ab->mesh();
    for(Halfedge_index h : b.mesh.halfedges())
      b.vector[h] = ab.vector(h);
    return Flat_triangulation(b);
  }

  Flat_triangulation ab;
};

// Returns whether A and C have a common edge that B has not. It remains two edges.
bool have_common_edges_beside_B(const Triangulation& ab, const Triangulation& bc)
{
  using Ends = std::set<std::pair<Vertex_index, Vertex_index>>;
  const auto ends_of = [](const Delta_complex& mesh) {
    Ends result;
    for(Edge_index e : mesh.edges())
      result.insert(std::minmax({mesh.vertex(e, 0), mesh.vertex(e, 1)}));
    return result;
  };
  const Ends a = ends_of(ab.input_mesh()), b = ends_of(ab.mesh()), c = ends_of(bc.mesh());
  return std::any_of(a.begin(), a.end(),
                     [&](const auto& e) { return b.count(e) == 0 && c.count(e) > 0; });
}

// Checks that all descriptions of a vertex belong to one point.
void check_places(const Subdivision& s, const Flat_triangulation& ab, const Flat_triangulation& bc)
{
  const Flat_places on_A(Side::input, ab), on_B(Side::intrinsic, ab), on_C(Side::intrinsic, bc);
  const double tolerance = 1e-11 * static_cast<double>(on_C.faces().longest_edge());
  for(Halfedge_index h : s.mesh().halfedges())
    if(!s.mesh().is_border(h)) {
      const Vertex_index v = s.mesh().target(h);
      const Complex b = on_B.place(IT::face_location(s.place(Layer::B, v), s.mesh(Layer::B)));
      EXPECT_LT(
        on_B.distance(on_A.place(IT::face_location(s.place(Layer::A, v), s.mesh(Layer::A))), b),
        tolerance)
        << v;
      EXPECT_LT(
        on_B.distance(on_C.place(IT::face_location(s.place(Layer::C, v), s.mesh(Layer::C))), b),
        tolerance)
        << v;
      EXPECT_LT(on_B.distance(on_A.place(s.location(Layer::A, h)), b), tolerance) << v;
      EXPECT_LT(on_B.distance(on_B.place(s.location(Layer::B, h)), b), tolerance) << v;
      EXPECT_LT(on_B.distance(on_C.place(s.location(Layer::C, h)), b), tolerance) << v;
      for(Layer layer : layers)
        EXPECT_EQ(s.location(layer, h).first, s.parent_face(layer, s.mesh().face(h)));
    }
}

// ---- Ideal geometry ----

using Ideal_traits = IT::Ideal_geometry_traits<double>;
using Ideal_triangulation = IT::Intrinsic_triangulation<Ideal_traits>;
using Ideal_correspondence = IT::Correspondence<Ideal_traits>;

struct Flip_recorder : IT::Default_flip_visitor
{
  void after_flip(Halfedge_index h) { flips.push_back(h); }
  std::vector<Halfedge_index> flips;
};

Ideal_triangulation ideal_triangulation(const Triangulation& b, const std::vector<double>& u)
{
  std::vector<double> lengths;
  for(Edge_index e : b.mesh().edges())
    lengths.push_back(std::exp((u[b.mesh().vertex(e, 0)] + u[b.mesh().vertex(e, 1)]) / 2) *
                      b.length(e));
  return triangulation<Ideal_traits>(b.mesh(), lengths);
}

// Returns the ideal Delaunay triangulation at random scale factors, if all lengths of `b` are
// equal.
Ideal_triangulation ideally_flipped(const Triangulation& b, double range, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> u(b.mesh().number_of_vertices());
  Ideal_triangulation result = ideal_triangulation(b, u);
  for(double& x : u)
    x = random.get_double(-range, range);
  Ideal_triangulation scaled = ideal_triangulation(b, u);
  Flip_recorder recorder;
  IT::make_Delaunay(scaled, CGAL::parameters::visitor(std::ref(recorder)));
  for(Halfedge_index h : recorder.flips)
    result.flip(h);
  return result;
}

// Returns a point in another face with the same corners, or the same corners that have weight, in
// some order.
Barycentric in_face(Face_index f, const Location& p, const Delta_complex& mesh)
{
  const auto from = IT::sides(p.first, mesh), to = IT::sides(f, mesh);
  Barycentric result{};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      if(mesh.source(from[i]) == mesh.source(to[j]))
        result[j] = p.second[i];
  return result;
}

bool has_three_vertices(Face_index f, const Delta_complex& mesh)
{
  std::set<Vertex_index> vertices;
  for(Halfedge_index h : IT::sides(f, mesh))
    vertices.insert(mesh.source(h));
  return vertices.size() == 3;
}

// Returns minus half the product of the vectors of two points of a face.
template <typename Lengths>
double product(const Barycentric& p, const Barycentric& q, Face_index f, const Delta_complex& mesh,
               const Lengths& length)
{
  double result = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double l = length[mesh.edge(IT::sides(f, mesh)[i])];
    result += l * l * (p[i] * q[j] + p[j] * q[i]);
  }
  return result;
}

// Returns the squared distance in the Euclidean face.
template <typename Lengths>
double squared_distance(const Barycentric& p, const Barycentric& q, Face_index f,
                        const Delta_complex& mesh, const Lengths& length)
{
  return product(p, q, f, mesh, length) -
         (product(p, p, f, mesh, length) + product(q, q, f, mesh, length)) / 2;
}

template <typename Lengths>
double longest_side(Face_index f, const Delta_complex& mesh, const Lengths& length)
{
  double result = 0;
  for(Halfedge_index h : IT::sides(f, mesh))
    result = (std::max)(result, length[mesh.edge(h)]);
  return result;
}

double greatest(const Barycentric& b) { return (std::max)({b[0], b[1], b[2]}); }

// Returns the number of pairs of corners.
std::size_t check_ideal(const Subdivision& s, const Triangulation& ab,
                        const Ideal_triangulation& bc)
{
  const auto &a = ab.input_mesh(), &b = ab.mesh(), &c = bc.mesh();
  std::size_t tested = 0;
  EXPECT_TRUE(s.mesh().is_valid(true));
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(a));
  for(Face_index f : s.mesh().faces()) {
    const Face_index f_a = s.parent_face(Layer::A, f), f_b = s.parent_face(Layer::B, f),
                     f_c = s.parent_face(Layer::C, f);
    if(!has_three_vertices(f_a, a) || !has_three_vertices(f_b, b))
      continue;
    std::vector<Barycentric> in_A, in_B, in_C;
    for(Halfedge_index h : sides_of(f, s)) {
      in_A.push_back(in_face(
        f_a, IT::face_location(s.place(Layer::A, s.mesh().target(h)), s.mesh(Layer::A)), a));
      in_B.push_back(in_face(
        f_b, IT::face_location(s.place(Layer::B, s.mesh().target(h)), s.mesh(Layer::B)), b));
      EXPECT_EQ(s.location(Layer::C, h).first, f_c);
      in_C.push_back(s.location(Layer::C, h).second);
    }
    const double size_of_A = longest_side(f_a, a, ab.input_length_map()),
                 size_of_B = longest_side(f_b, b, ab.length_map()),
                 size_of_C = longest_side(f_c, c, bc.length_map());
    for(std::size_t i = 0; i < in_A.size(); ++i) {
      const std::size_t j = (i + 1) % in_A.size(), k = (i + 2) % in_A.size();
      EXPECT_GT(IT::internal::orientation(in_A[i], in_A[j], in_A[k]), -1e-13);
      EXPECT_GT(IT::internal::orientation(in_B[i], in_B[j], in_B[k]), -1e-13);
      EXPECT_GT(IT::internal::orientation(in_C[i], in_C[j], in_C[k]),
                -1e-13 * greatest(in_C[i]) * greatest(in_C[j]) * greatest(in_C[k]));
      for(std::size_t l = 0; l <= i; ++l) {
        const double scale =
          size_of_B * size_of_B + size_of_C * size_of_C * greatest(in_C[i]) * greatest(in_C[l]);
        EXPECT_NEAR(product(in_C[i], in_C[l], f_c, c, bc.length_map()),
                    product(in_B[i], in_B[l], f_b, b, ab.length_map()), 1e-12 * scale);
        EXPECT_NEAR(squared_distance(in_A[i], in_A[l], f_a, a, ab.input_length_map()),
                    squared_distance(in_B[i], in_B[l], f_b, b, ab.length_map()),
                    1e-12 * (size_of_A * size_of_A + size_of_B * size_of_B));
        ++tested;
      }
    }
  }
  return tested;
}

TEST(Chord_crossings, as_by_brute_force)
{
  CGAL::Random random(1);
  DCM::internal::Chord_crossings crossings;
  for(int round = 0; round < 2000; ++round) {
    // Families of chords are two sequences of brackets, shuffled.
    std::array<std::vector<int>, 2> open;
    std::array<std::vector<std::array<std::size_t, 2>>, 2> chords;
    std::vector<std::pair<std::size_t, std::size_t>> ends; // family, chord
    const int n = random.get_int(0, 30);
    for(int i = 0; i < n || !open[0].empty() || !open[1].empty(); ++i) {
      const std::size_t k = static_cast<std::size_t>(random.get_int(0, 2));
      if(i < n && (open[k].empty() || random.get_int(0, 2) == 0)) {
        open[k].push_back(static_cast<int>(chords[k].size()));
        ends.emplace_back(k, chords[k].size());
        chords[k].push_back({ends.size() - 1, 0});
      } else if(!open[k].empty()) {
        const auto c = static_cast<std::size_t>(open[k].back());
        open[k].pop_back();
        ends.emplace_back(k, c);
        chords[k][c][1] = ends.size() - 1;
      }
    }
    std::vector<std::size_t> sequence;
    for(const auto& [k, c] : ends)
      sequence.push_back(k == 0 ? c : chords[0].size() + c);
    crossings.compute({chords[0].size(), chords[1].size()}, sequence);
    std::size_t total = 0;
    for(std::size_t k = 0; k < 2; ++k)
      for(std::size_t c = 0; c < chords[k].size(); ++c) {
        const auto [begin, end] = chords[k][c];
        const std::size_t number = k == 0 ? c : chords[0].size() + c;
        std::vector<std::size_t> expected, found;
        for(std::size_t p = begin + 1; p < end; ++p)
          if(const auto [l, d] = ends[p]; l != k)
            if((chords[l][d][0] < begin) != (chords[l][d][1] > end))
              expected.push_back(sequence[p]);
        for(std::size_t r = 0; r < crossings.number_on(number); ++r) {
          const auto& x = crossings[crossings.on(number, r)];
          const bool is_earlier = x.earlier == number;
          EXPECT_TRUE(is_earlier || x.later == number);
          EXPECT_EQ(x.rank[is_earlier ? 0 : 1], r);
          found.push_back(is_earlier ? x.later : x.earlier);
        }
        EXPECT_EQ(found, expected);
        total += found.size();
      }
    EXPECT_EQ(total, 2 * crossings.size());
  }
}

TEST(Triple_subdivision, numbers)
{
  for(const Named_three& t : traced(all_threes()))
    check_numbers(t.three.subdivision(), t.three);
}

TEST(Triple_subdivision, areas_and_lengths_add_up)
{
  for(const Named_three& t : traced(all_threes()))
    check_measures(t.three.subdivision(), t.three, 1e-8);
}

TEST(Triple_subdivision, vertices_are_where_all_descriptions_say)
{
  for(const auto& [surface, seed] : traced(flat_surfaces(), 5)) {
    Flat_three three(surface.surface);
    three.ab.flip_at_random(500, seed);
    Flat_triangulation bc = three.next();
    bc.flip_at_random(500, seed + 100);
    check_places(Subdivision(Correspondence(*three.ab), Correspondence(*bc)), three.ab, bc);
  }
}

TEST(Triple_subdivision, triangulate)
{
  for(const Named_three& t : traced(all_threes())) {
    Subdivision s = t.three.subdivision();
    s.triangulate();
    for(Face_index f : s.mesh().faces())
      EXPECT_EQ(sides_of(f, s).size(), 3u);
    EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.three.mesh(Layer::A)));
    check_measures(s, t.three, 1e-8);
  }
}

TEST(Triple_subdivision, linear_functions_in_the_plane_from_every_layer)
{
  for(unsigned int seed : seeds(3)) {
    Flat_three three(flat_grid(7, 6, seed));
    three.ab.flip_at_random(1000, seed);
    Flat_triangulation bc = three.next();
    bc.flip_at_random(1000, seed + 100);
    const Subdivision s(Correspondence(*three.ab), Correspondence(*bc));
    const auto linear = boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
      const Vector p = three.ab.surface().point[v];
      return 3 + 0.7 * static_cast<double>(p.x) - 0.2 * static_cast<double>(p.y);
    });
    std::array<std::vector<double>, 3> value;
    for(Layer layer : layers) {
      auto& values = value[static_cast<std::size_t>(layer)];
      values.resize(s.mesh().number_of_vertices());
      IT::interpolate(
        layer, s, linear,
        boost::make_iterator_property_map(values.begin(), boost::identity_property_map()));
    }
    for(Vertex_index v : s.mesh().vertices()) {
      EXPECT_NEAR(value[0][v], value[1][v], 1e-12 * 7000);
      EXPECT_NEAR(value[0][v], value[2][v], 1e-12 * 7000);
    }
  }
}

TEST(Triple_subdivision, agrees_with_an_arrangement_of_segments)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
  const auto exact = [](const Vector& p) {
    return Exact::Point_2(static_cast<double>(p.x), static_cast<double>(p.y));
  };
  std::size_t vertices = 0;
  for(unsigned int seed : seeds(30)) {
    Flat_three three(seed % 2 == 0 ? flat_grid(2 + seed % 3, 3, seed)
                                   : flat_polygon(random_points(8 + seed / 2, 1 << 19, seed)));
    if(seed % 3 == 0)
      three.ab.make_Delaunay();
    else
      three.ab.flip_at_random(1000, seed);
    Flat_triangulation bc = three.next();
    for(unsigned int round = 0;
        round == 0 || (round < 1000 && have_common_edges_beside_B(*three.ab, *bc)); ++round)
      bc.flip_at_random(20, 1000 * seed + round);
    if(have_common_edges_beside_B(*three.ab, *bc))
      continue;
    std::vector<Exact::Segment_2> segments;
    for(const Delta_complex* mesh : {&three.ab->input_mesh(), &three.ab->mesh(), &bc->mesh()})
      for(Edge_index e : mesh->edges())
        segments.emplace_back(exact(bc.surface().point[mesh->vertex(e, 0)]),
                              exact(bc.surface().point[mesh->vertex(e, 1)]));
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());
    const Subdivision s(Correspondence(*three.ab), Correspondence(*bc));
    EXPECT_EQ(s.mesh().number_of_vertices(), arrangement.number_of_vertices());
    EXPECT_EQ(s.mesh().number_of_edges(), arrangement.number_of_edges());
    EXPECT_EQ(s.mesh().number_of_faces() + 1, arrangement.number_of_faces());
    vertices += s.mesh().number_of_vertices();
  }
  EXPECT_GT(vertices, 1000u);
}

TEST(Triple_subdivision, of_three_equal_triangulations_is_the_input)
{
  for(const Named_complex& complex : traced(complexes())) {
    const Three three(triangulation(complex.mesh, random_lengths(complex.mesh, 1)));
    const Subdivision s = three.subdivision();
    EXPECT_EQ(s.mesh().number_of_vertices(), complex.mesh.number_of_vertices());
    EXPECT_EQ(s.mesh().number_of_edges(), complex.mesh.number_of_edges());
    EXPECT_EQ(s.mesh().number_of_faces(), complex.mesh.number_of_faces());
    for(Edge_index e : s.mesh().edges())
      for(Layer layer : layers)
        EXPECT_EQ(s.parent_edge(layer, e), e);
  }
}

TEST(Triple_subdivision, is_that_of_two_if_two_are_equal)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const IT::Common_subdivision<> expected{Correspondence(t.triangulation)};
    const Triangulation a = triangulation(t.triangulation.input_mesh(), [&] {
      std::vector<double> lengths;
      for(Edge_index e : t.triangulation.input_mesh().edges())
        lengths.push_back(t.triangulation.input_length(e));
      return lengths;
    }());
    const Three b_is_c(t.triangulation);
    const Subdivision first = b_is_c.subdivision();
    const Subdivision second(Correspondence(a), Correspondence(t.triangulation));
    for(const Subdivision* s : {&first, &second}) {
      EXPECT_EQ(s->mesh().number_of_vertices(), expected.mesh().number_of_vertices());
      EXPECT_EQ(s->mesh().number_of_edges(), expected.mesh().number_of_edges());
      EXPECT_EQ(s->mesh().number_of_faces(), expected.mesh().number_of_faces());
    }
  }
}

// All flips are undone. Edges of A and C that are not in B are the same, and have their marks at
// equal positions, up to rounding.
TEST(Triple_subdivision, of_coinciding_edges)
{
  for(const Named_surface& surface : traced(flat_surfaces()))
    for(unsigned int seed : seeds(5)) {
      Triangulation t = triangulation(surface.surface);
      std::vector<Halfedge_index> flipped;
      flip_at_random(t, 200, seed, [&](Halfedge_index h) { flipped.push_back(h); });
      Three three(t);
      for(auto h = flipped.rbegin(); h != flipped.rend(); ++h)
        three.bc.flip(*h);
      const Subdivision s = three.subdivision();
      check_numbers(s, three);
      check_measures(s, three, 1e-8);
    }
}

TEST(Triple_subdivision, of_a_large_mesh)
{
  Flat_three three(flat_grid(80, 80, 1));
  three.ab.flip_at_random(30000, 1);
  Flat_triangulation bc = three.next();
  bc.flip_at_random(30000, 2);
  const Subdivision s(Correspondence(*three.ab), Correspondence(*bc));
  EXPECT_TRUE(s.mesh().is_valid(true));
  EXPECT_EQ(Euler_characteristic(s.mesh()), 1);
  check_places(s, three.ab, bc);
}

TEST(Triple_subdivision, copies_and_moved_ones_are_independent)
{
  Three three{Triangulation(embedded_torus(5, 4))};
  IT::make_Delaunay(three.bc);
  Subdivision s = three.subdivision();
  const Subdivision copy(s);
  const Subdivision moved(std::move(s));
  check_measures(copy, three, 1e-8);
  check_measures(moved, three, 1e-8);
}

// With light-like vectors of the corners, products of points are products of weights. If these are
// equal for all corners of a face in B and in C, the two layouts in the light cone are congruent.
TEST(Triple_subdivision, in_ideal_geometry)
{
  std::size_t tested = 0;
  for(const auto& [m, seed] : traced(meshes(), 4)) {
    Triangulation ab(m.mesh);
    if(seed > 0)
      flip_at_random(ab, 5 * m.mesh.number_of_edges(), seed);
    IT::make_Delaunay(ab);
    const Ideal_triangulation bc = ideally_flipped(ab, 0.2 + 0.5 * seed, seed);
    tested += check_ideal(Subdivision(Correspondence(ab), Ideal_correspondence(bc)), ab, bc);
  }
  EXPECT_GT(tested, 5000u);
}

// Each edge has the length of its own triangulation.
TEST(Triple_subdivision, positions_in_space)
{
  for(const Named_mesh& m : traced(meshes()))
    for(unsigned int seed : seeds(3)) {
      Triangulation ab(m.mesh);
      flip_at_random(ab, 10 * m.mesh.number_of_edges(), seed);
      Three three(ab);
      flip_at_random(three.bc, 10 * m.mesh.number_of_edges(), seed + 9);
      DCM::Triple_subdivision<double, Point> s{Correspondence(three.ab), Correspondence(three.bc)};
      const auto points = boost::make_function_property_map<Vertex_index>(
        [&](Vertex_index v) { return m.mesh.point(v); });
      IT::interpolate(Layer::A, s, points, s.mesh().points());
      for(Vertex_index v : m.mesh.vertices())
        EXPECT_EQ(s.mesh().point(v), m.mesh.point(v));
      for(Layer layer : layers) {
        std::vector<double> length(three.mesh(layer).number_of_edges());
        for(Edge_index e : s.mesh().edges())
          if(const Edge_index parent = s.parent_edge(layer, e); parent.is_valid())
            length[parent] += std::sqrt(CGAL::squared_distance(
              s.mesh().point(s.mesh().vertex(e, 0)), s.mesh().point(s.mesh().vertex(e, 1))));
        for(Edge_index e : three.mesh(layer).edges())
          EXPECT_NEAR(length[e] / three.length(layer, e), 1, 1e-9);
      }
    }
}

// Edges of A wind one way around a cylinder, and edges of C the other way. They cross again and
// again.
TEST(Triple_subdivision, of_twisted_edges)
{
  for(const int twists : traced({1, 3, 30})) {
    Flat_triangulation ab(flat_cylinder(1, twists));
    ab.make_Delaunay();
    Three three(*ab);
    const Delta_complex& mesh = three.bc.mesh();
    std::vector<Vector> vector;
    for(Halfedge_index h : mesh.halfedges())
      vector.push_back(ab.vector(h));
    for(int i = 0; i < 2 * twists; ++i) {
      Halfedge_index rightmost;
      for(Halfedge_index h : mesh.halfedges())
        if(vector[h].y > 0 && (!rightmost.is_valid() || vector[h].x > vector[rightmost].x))
          rightmost = h;
      three.bc.flip(rightmost);
      vector[rightmost] = -(vector[mesh.next(rightmost)] + vector[mesh.prev(rightmost)]);
      vector[mesh.opposite(rightmost)] = -vector[rightmost];
    }
    const Subdivision s = three.subdivision();
    EXPECT_GT(s.mesh().number_of_vertices(), static_cast<std::size_t>(20 * twists));
    check_numbers(s, three);
    check_measures(s, three, 1e-8);
  }
}

TEST(Triple_subdivision, of_data_meshes)
{
  for_each_data_mesh(200000, [](const Mesh& mesh) {
    Triangulation ab(mesh);
    IT::make_Delaunay(ab);
    const Ideal_triangulation bc = ideally_flipped(ab, 1, 1);
    const Subdivision s{Correspondence(ab), Ideal_correspondence(bc)};
    EXPECT_TRUE(s.mesh().is_valid(false));
    EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(mesh));
    for(Face_index f : s.mesh().faces())
      EXPECT_GE(sides_of(f, s).size(), 3u);
  });
}

TEST(Triple_subdivision, of_the_empty_surface)
{
  const Triangulation t;
  EXPECT_TRUE(Subdivision(Correspondence(t), Correspondence(t)).mesh().is_empty());
}

} // namespace Test_triple_subdivision
