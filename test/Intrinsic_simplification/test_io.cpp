// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests save and load hierarchies.

#include "../Intrinsic_triangulations/equality.h"
#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/io.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/input_with_inserted_vertices.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_io {

using namespace Test_surfaces;
using IS::read_surface_hierarchy;
using IS::Surface_hierarchy;
using IS::write_surface_hierarchy;

std::string saved(const Evolving_surface& surface, const std::vector<const Surface_level*>& levels)
{
  std::ostringstream text;
  EXPECT_TRUE(write_surface_hierarchy(text, surface.history(), levels));
  return text.str();
}

Surface_hierarchy loaded(const std::string& text)
{
  std::istringstream is(text);
  return read_surface_hierarchy(is);
}

void expect_equal(const Surface_level& a, const Surface_level& b)
{
  EXPECT_EQ(a.time(), b.time());
  Test_surfaces::expect_equal(a.mesh(), b.mesh());
  for(Edge_index e : a.mesh().edges())
    EXPECT_EQ(a.length_map()[e], b.length_map()[e]);
  for(Face_index f : a.mesh().faces())
    EXPECT_EQ(a.surface_face(f), b.surface_face(f));
  for(Vertex_index v : a.mesh().vertices())
    EXPECT_EQ(a.surface_vertex(v), b.surface_vertex(v));
}

TEST(Surface_hierarchy, is_read_as_it_was_written)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    if(s.fine.time() > 0)
      return; // a hierarchy begins with the surface before all operations
    const std::string text = saved(s.surface, {&s.fine, &s.coarse});
    const Surface_hierarchy read = loaded(text);
    ASSERT_EQ(read.levels.size(), 2u);
    expect_equal(read.levels[0], s.fine);
    expect_equal(read.levels[1], s.coarse);
    const Surface_map again(read.history, read.levels[0], read.levels[1]);
    for(Face_index f : s.fine.mesh().faces())
      for(const Coordinates& p : {Coordinates{0.2, 0.3, 0.5}, Coordinates{0, 0.75, 0.25}})
        EXPECT_EQ(map.to_coarse({f, p}), again.to_coarse({f, p}));
    std::ostringstream twice;
    write_surface_hierarchy(twice, read.history, {&read.levels[0], &read.levels[1]});
    EXPECT_EQ(twice.str(), text);
  });
}

TEST(Surface_hierarchy, of_many_levels)
{
  Evolving_surface surface(random_sphere(200, 7));
  std::vector<Surface_level> levels{Surface_level(surface)};
  for(const std::size_t n : {std::size_t(100), std::size_t(50), std::size_t(50), std::size_t(10)}) {
    simplify(surface, number_of_vertices(n));
    levels.emplace_back(surface);
  }
  std::vector<const Surface_level*> pointers;
  for(const Surface_level& level : levels)
    pointers.push_back(&level);
  const Surface_hierarchy read = loaded(saved(surface, pointers));
  ASSERT_EQ(read.levels.size(), 5u);
  for(std::size_t n = 0; n < 5; ++n)
    expect_equal(read.levels[n], levels[n]);
  EXPECT_EQ(read.history.size(), surface.history().size());
}

// A triangulation with inserted vertices and its simplification are in one stream. Points of the
// input are mapped to the coarse surface and back.
TEST(Surface_hierarchy, follows_a_refinement)
{
  const Mesh mesh = punctured(random_sphere(60, 9), {3});
  IT::Intrinsic_triangulation<> refined(mesh);
  IT::refine(refined);
  refined.collect_garbage();
  ASSERT_GT(refined.number_of_inserted_vertices(), 10u);
  const auto start = IT::input_with_inserted_vertices(refined);
  const Simplified s(Evolving_surface(start), 30);
  std::stringstream stream;
  ASSERT_TRUE(IT::write_intrinsic_triangulation(stream, start));
  ASSERT_TRUE(write_surface_hierarchy(stream, s.surface.history(), {&s.fine, &s.coarse}));
  const auto first = IT::read_intrinsic_triangulation(stream);
  const Surface_hierarchy second = read_surface_hierarchy(stream);
  const IT::Correspondence<> correspondence(first);
  const Surface_map map(second.history, second.levels[0], second.levels[1]);
  for(Face_index f : mesh.faces()) {
    const Location p{f, {0.2, 0.3, 0.5}};
    const Location fine = IT::point_across(correspondence, IT::Side::input, p);
    const Location back = map.to_fine(map.to_coarse(fine));
    expect_same_place(IT::point_across(correspondence, IT::Side::intrinsic, back), p,
                      first.input_mesh());
  }
}

// Every missing line, and every corrupted number, is found, or makes another valid file.
TEST(Surface_hierarchy, of_spoilt_files)
{
  const Simplified s(Evolving_surface(punctured(random_sphere(20, 6), {0})), 6);
  const std::string text = saved(s.surface, {&s.fine, &s.coarse});
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for(std::string line; std::getline(stream, line);)
    lines.push_back(line);
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string result;
    for(const std::string& part : parts)
      result += part + '\n';
    return result;
  };
  for(std::size_t n = 0; n < lines.size(); ++n) {
    SCOPED_TRACE("line " + std::to_string(n + 1));
    std::vector<std::string> without = lines;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(n));
    EXPECT_ANY_THROW(loaded(joined(without)));
    for(const char* other : {"", "x", "-1", "3 0 3 0x1p-1 0x1p-1", "1 99999 0x1p-1 0x1p-1",
                             "0 5 1 -0x1p+0", "1 0 0x1p+1 0x1p-1"}) {
      std::vector<std::string> spoilt = lines;
      spoilt[n] = other;
      EXPECT_ANY_THROW(loaded(joined(spoilt))) << other;
    }
  }
}

} // namespace Test_io
