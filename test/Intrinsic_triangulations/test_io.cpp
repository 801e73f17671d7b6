// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Sqrt_extension.h>

#include <cctype>
#ifdef __linux__
#include <sys/resource.h>
#endif

namespace Test_io {

using namespace Test_surfaces;

// Returns what is loaded after `t` has been saved.
Triangulation checked_round_trip(const Triangulation& t)
{
  const std::string text = text_of(t);
  Triangulation loaded = triangulation_of(text);
  expect_equal(t, loaded);
  EXPECT_EQ(text_of(loaded), text);
  EXPECT_TRUE(loaded.is_valid(true));
  return loaded;
}

void check_round_trip(const Triangulation& t)
{
  Triangulation loaded = checked_round_trip(t);
  Triangulation original(t); // what is loaded works as what was saved
  EXPECT_EQ(IT::make_Delaunay(original), IT::make_Delaunay(loaded));
  expect_equal(original, loaded);
  EXPECT_EQ(flip_to_input(original), flip_to_input(loaded));
  expect_equal(original, loaded);
}

// ---- Damage ----

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text)
{
  Lines result;
  std::istringstream is(text);
  for(std::string line; std::getline(is, line);)
    result.push_back(line);
  return result;
}

std::string joined(const Lines& lines, char separator)
{
  std::string result;
  for(const std::string& line : lines)
    result += line + separator;
  return result;
}

enum class Outcome
{
  bad_format,
  bad_triangulation,
  valid
};

// Returns the outcome. Only these two errors and a valid triangulation are allowed.
Outcome outcome(const std::string& text)
{
  try {
    const Triangulation t = triangulation_of(text);
    EXPECT_TRUE(t.is_valid(true)) << text;
    expect_equal(triangulation_of(text_of(t)), t);
    return Outcome::valid;
  } catch(const IT::File_format_error& error) {
    EXPECT_GE(error.line(), 1u);
    EXPECT_LE(error.line(), lines_of(text).size() + 1);
    EXPECT_NE(std::string(error.what()).find("line " + std::to_string(error.line())),
              std::string::npos);
    return Outcome::bad_format;
  } catch(const IT::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()), "");
    return Outcome::bad_triangulation;
  } catch(const std::exception& error) {
    ADD_FAILURE() << error.what() << "\n" << text;
    return Outcome::bad_triangulation;
  }
}

// Returns the line for which a damaged text is rejected.
std::size_t refused_line(const std::string& text)
{
  try {
    triangulation_of(text);
  } catch(const IT::File_format_error& error) {
    return error.line();
  }
  ADD_FAILURE() << "not refused";
  return 0;
}

// Returns the line for which the text is rejected after a line has been replaced.
std::size_t refused_line(Lines lines, std::size_t line, const std::string& replacement)
{
  lines[line - 1] = replacement;
  return refused_line(joined(lines, '\n'));
}

std::vector<Triangulation> small_triangulations()
{
  std::vector<Triangulation> result{
    Triangulation(tetrahedron()), triangulation(cone(false), {1, 1}),
    triangulation(bigon(), {1, 1.2, 1, 1.4}), triangulation(flat_torus(1, 1, 0))};
  Mesh lonely =
    make_mesh({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 2, 3}, {2, 4, 3}});
  result.emplace_back(
    lonely, CGAL::parameters::edge_is_constrained_map(boost::make_function_property_map<Edge_index>(
              [](Edge_index e) { return e.idx() % 2 == 0; })));
  for(std::size_t i = 0; i < 4; ++i)
    flip_at_random(result[i], 40, 3);
  return result;
}

const Lines& replacements()
{
  static const Lines result = [] {
    Lines all =
      words("-2 -1 0 1 2 7 10 1000 1e3 1.5 x nan 0xnan 0xinf -0x1p+0 0x-1p0 0x 0x0p+0 0x1p+0 "
            "0x1p-1080 0x1p+1023 0x1p+99999 576460752303423487 9223372036854775807 "
            "9223372036854775808 -9223372036854775809 4294967295 99999999999999999999999");
    all.emplace_back();
    return all;
  }();
  return result;
}

// Returns whether the words are three numbers of elements, or a position.
bool are_counts(const Lines& words)
{
  return words.size() == 3 && words[0].find('x') == std::string::npos;
}

// Replaces every number of every line except for the numbers of elements, which another test
// changes.
template <typename Check>
void for_each_replacement(const std::string& text, const Check& check)
{
  const Lines lines = lines_of(text);
  for(std::size_t l = 1; l < lines.size(); ++l) {
    std::istringstream is(lines[l]);
    Lines words;
    for(std::string word; is >> word;)
      words.push_back(word);
    for(std::size_t w = 0; w < words.size() && !are_counts(words); ++w)
      for(const std::string& replacement : replacements()) {
        Lines new_words = words, new_lines = lines;
        new_words[w] = replacement;
        new_lines[l] = joined(new_words, ' ');
        check(joined(new_lines, '\n'));
      }
  }
}

TEST(IO, round_trip)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_round_trip(t.triangulation);
  for(const Triangulation& t : small_triangulations())
    check_round_trip(t);
  check_round_trip(Triangulation());
}

TEST(IO, round_trip_with_constraints)
{
  for(const Named_mesh& m : traced(meshes())) {
    const auto third =
      boost::make_function_property_map<Edge_index>([](Edge_index e) { return e.idx() % 3 == 0; });
    Triangulation t(m.mesh, CGAL::parameters::edge_is_constrained_map(third));
    flip_at_random(t, std::size_t(20) * m.mesh.number_of_edges(), 1);
    check_round_trip(t);
  }
}

std::size_t number_of_constraints(const Triangulation& t)
{
  const auto edges = t.mesh().edges();
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [&](Edge_index e) { return t.is_constrained(e); }));
}

// Returns T2 where constrained edges cross the input. Every second such edge is constrained.
Triangulation with_crossing_constraints(const Mesh& mesh, unsigned int seed)
{
  Triangulation t(mesh);
  flip_at_random(t, std::size_t(2) * mesh.number_of_edges(), seed);
  for(Edge_index e : t.mesh().edges())
    t.set_constrained(e, !t.coordinates().is_shared(e) && e.idx() % 2 == 0);
  return t;
}

// A restart from the input drops constraints of edges that are not in the input.
TEST(IO, constraints_that_cross_the_input)
{
  std::size_t constrained = 0, insertions = 0;
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t = with_crossing_constraints(m.mesh, 1);
    constrained += number_of_constraints(t);
    check_round_trip(t);
    Triangulation flipped = triangulation_of(text_of(t));
    flip_to_input(flipped);
    EXPECT_EQ(number_of_constraints(flipped), 0u);

    t = triangulation_of(text_of(t));
    insertions += IT::refine(t, IT::parameters::minimum_angle(20)).insertions;
    EXPECT_TRUE(IT::is_Delaunay(t));
    IT::certify_Delaunay(t);
    checked_round_trip(t);
    t.reset_to_input();
    EXPECT_EQ(number_of_constraints(t), 0u);
  }
  EXPECT_GT(constrained, 100u);
  EXPECT_GT(insertions, 100u);
}

TEST(IO, lengths_of_all_magnitudes_are_exact)
{
  for(double scale : {1e-36, 3e-20, 1 / 3., 1e20, 1e36}) {
    std::vector<double> lengths = random_lengths(double_torus(), 1);
    for(double& length : lengths)
      length *= scale;
    check_round_trip(triangulation(double_torus(), lengths));
  }
}

TEST(IO, header)
{
  const std::string text = text_of(Triangulation(tetrahedron()));
  EXPECT_EQ(lines_of(text)[0], "intrinsic_triangulation 3");
  for(const char* header : {"", "intrinsic_triangulation 1", "intrinsic_triangulation", "OFF",
                            " intrinsic_triangulation 3", "intrinsic_triangulation 3 "}) {
    Lines lines = lines_of(text);
    lines[0] = header;
    EXPECT_EQ(refused_line(joined(lines, '\n')), 1u);
  }
  EXPECT_EQ(refused_line(""), 1u);
}

TEST(IO, missing_lines)
{
  for(const Triangulation& t : small_triangulations()) {
    const Lines lines = lines_of(text_of(t));
    for(std::size_t l = 0; l < lines.size(); ++l) {
      Lines fewer = lines;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(l));
      EXPECT_NE(outcome(joined(fewer, '\n')), Outcome::valid) << l;
    }
  }
}

TEST(IO, repeated_and_exchanged_lines)
{
  for(const Triangulation& t : small_triangulations()) {
    const Lines lines = lines_of(text_of(t));
    for(std::size_t l = 0; l < lines.size(); ++l) {
      Lines more = lines;
      more.insert(more.begin() + static_cast<std::ptrdiff_t>(l), lines[l]);
      outcome(joined(more, '\n'));
      for(std::size_t k = 0; k < l; ++k) {
        Lines exchanged = lines;
        std::swap(exchanged[k], exchanged[l]);
        outcome(joined(exchanged, '\n'));
      }
    }
  }
}

TEST(IO, truncated_at_every_byte)
{
  for(const Triangulation& t : small_triangulations()) {
    const std::string text = text_of(t);
    for(std::size_t size = 0; size + 1 < text.size(); ++size) {
      const Outcome o = outcome(text.substr(0, size));
      // The last number may have lost digits.
      EXPECT_TRUE(o != Outcome::valid || text.find('\n', size) + 1 == text.size()) << size;
    }
  }
}

TEST(IO, extra_text_in_every_line)
{
  const Lines lines = lines_of(text_of(Triangulation(tetrahedron())));
  for(std::size_t l = 0; l < lines.size(); ++l)
    for(const char* extra : {" 0", " x", "x", ".", "\t", "\r"}) {
      Lines longer = lines;
      longer[l] += extra;
      EXPECT_EQ(refused_line(joined(longer, '\n')), l + 1) << extra;
    }
}

TEST(IO, other_numbers)
{
  std::size_t valid = 0, bad_format = 0, bad_triangulation = 0;
  for(const Triangulation& t : small_triangulations())
    for_each_replacement(text_of(t), [&](const std::string& damaged) {
      const Outcome o = outcome(damaged);
      ++(o == Outcome::valid ? valid : o == Outcome::bad_format ? bad_format : bad_triangulation);
    });
  EXPECT_GT(valid, 0u);
  EXPECT_GT(bad_format, 1000u);
  EXPECT_GT(bad_triangulation, 500u);
}

TEST(IO, other_numbers_of_elements)
{
  const Lines lines = lines_of(text_of(Triangulation(tetrahedron())));
  for(std::size_t l : {std::size_t(1), (lines.size() - 5) / 2}) { // without the positions
    ASSERT_EQ(lines[l], "4 6 4");
    for(const char* counts : {"", "4", "4 6", "3 6 4", "4 5 4", "4 6 3", "5 6 4", "4 7 4", "4 6 5",
                              "0 0 0", "-4 6 4", "4 -6 4", "4 6 -4", "4 6 4294967296",
                              "18446744073709551616 6 4", "1e9 6 4", "0 6 4", "4 0 4", "4 6 0"}) {
      Lines changed = lines;
      changed[l] = counts;
      EXPECT_NE(outcome(joined(changed, '\n')), Outcome::valid) << counts;
    }
  }
}

TEST(IO, faces_that_share_halfedges)
{
  const Lines lines = lines_of(text_of(Triangulation(tetrahedron())));
  for(std::size_t first_face : {13u, 28u})
    for(std::size_t line = first_face + 1; line < first_face + 4; ++line)
      EXPECT_EQ(refused_line(lines, line, lines[line - 2]), line);
}

TEST(IO, inserted_vertices_beside_their_halfedges)
{
  Triangulation t(tetrahedron());
  IT::Vertex_inserter<>(t).split_edge(Halfedge_index(0), 0.5);
  const Lines lines = lines_of(text_of(t));
  const std::size_t line = lines.size() - 5; // positions follow
  const std::string expected = lines[line - 1];
  ASSERT_EQ(expected.substr(0, 2), "0 ");
  EXPECT_EQ(refused_line(lines, line, "1" + expected.substr(1)), line);
}

TEST(IO, lengths_that_make_no_triangle)
{
  for(const Triangulation& t :
      {Triangulation(tetrahedron()), Triangulation(embedded_torus(5, 4))}) {
    const Lines lines = lines_of(text_of(t));
    for(std::size_t l = 0; l < lines.size(); ++l)
      if(const std::size_t from = lines[l].find("0x"); from != std::string::npos) {
        const std::size_t to = (std::min)(lines[l].find(' ', from), lines[l].size());
        Lines changed = lines;
        changed[l].replace(from, to - from, "0x1p+60");
        EXPECT_EQ(outcome(joined(changed, '\n')), Outcome::bad_triangulation) << changed[l];
      }
  }
}

// The lengths are wrong in the second triangulation alone, at an edge that is not shared.
TEST(IO, intrinsic_lengths_that_make_no_triangle)
{
  Triangulation t(embedded_torus(5, 4));
  EXPECT_GT(IT::make_Delaunay(t), 0u);
  Lines lines = lines_of(text_of(t));
  const std::size_t first = lines.size() - 2 - t.mesh().number_of_vertices() -
                            t.mesh().number_of_faces() - t.mesh().number_of_edges();
  for(Edge_index e : t.mesh().edges())
    if(t.coordinates().normal_coordinate(e) > 0) {
      Lines changed = lines;
      std::string& line = changed[first + e.idx()];
      const std::size_t from = line.find("0x"), to = line.find(' ', from);
      line.replace(from, to - from, "0x1p+60");
      EXPECT_EQ(outcome(joined(changed, '\n')), Outcome::bad_triangulation) << line;
    }
}

// ---- What is exact stays so ----

template <typename Tri>
Tri reloaded(const Tri& t)
{
  std::stringstream stream;
  EXPECT_TRUE(IT::write_intrinsic_triangulation(stream, t));
  return IT::read_intrinsic_triangulation<typename Tri::Traits>(stream);
}

// All diamonds of a plane grid, turned in space, are ties, which no lengths in `double` show.
TEST(IO, ties_of_positions_are_kept)
{
  const Mesh mesh = grid(8, 4, [](double x, double y) {
    return Point(2 * x + 3 * y + 1, 3 * x - 6 * y - 7, 6 * x + 2 * y);
  });
  typedef IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>> Exact;
  Exact exact(mesh);
  IT::make_Delaunay(exact);
  const IT::Delaunay_certificate expected = IT::certify_Delaunay(exact);
  EXPECT_GT(expected.ties.size(), 0u);
  const IT::Delaunay_certificate found = IT::certify_Delaunay(reloaded(exact));
  EXPECT_TRUE(found.is_Delaunay());
  EXPECT_EQ(found.ties, expected.ties);
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  EXPECT_EQ(IT::certify_Delaunay(reloaded(t)).ties, IT::certify_Delaunay(t).ties);
}

// In a square with diagonal sqrt(2), two edges of a flat torus are equally long diagonals.
TEST(IO, ties_of_squared_lengths_are_kept)
{
  typedef IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>> Exact;
  const Delta_complex mesh = glue({{1, 2, 3}, {-1, -2, -3}});
  for(int scale : {1, 3, 7}) {
    const auto square = boost::make_function_property_map<Edge_index>([&](Edge_index e) {
      return CGAL::Exact_rational(CGAL::Exact_rational(e.idx() == 2 ? 2 : 1) / scale);
    });
    const Exact exact(mesh, IT::parameters::squared_edge_length_map(square));
    EXPECT_EQ(IT::certify_Delaunay(exact).ties.size(), 1u);
    EXPECT_EQ(IT::certify_Delaunay(reloaded(exact)).ties.size(), 1u);
    std::stringstream stream;
    EXPECT_TRUE(IT::write_intrinsic_triangulation(stream, exact));
    EXPECT_EQ(IT::read_intrinsic_triangulation(stream).length(Edge_index(2)),
              exact.length(Edge_index(2)));
  }
}

using Q_of_roots = CGAL::Sqrt_extension<CGAL::Exact_rational, CGAL::Exact_rational>;

// The diagonals of a rhombus with sides 1 and an angle of 45 degrees have the squares 2 -+ sqrt(2).
TEST(IO, ties_of_lengths_in_an_extension_are_kept)
{
  typedef IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<Q_of_roots>> Exact;
  Delta_complex mesh = glue({{1, 2, 3}, {-1, -2, -3}});
  auto square = mesh.add_property_map<Edge_index, Q_of_roots>("e:square", Q_of_roots(1)).first;
  for(const Q_of_roots& diagonal : {Q_of_roots(2, -1, 2), Q_of_roots(2), Q_of_roots(0, 1, 2)})
    for(int scale : {1, 3, 7}) {
      square[Edge_index(0)] = square[Edge_index(1)] = Q_of_roots(1) / Q_of_roots(scale);
      square[Edge_index(2)] = diagonal / Q_of_roots(scale);
      const Exact exact(mesh, IT::parameters::squared_edge_length_map(square));
      const std::size_t ties = diagonal == Q_of_roots(2) ? 1 : 0;
      EXPECT_EQ(IT::certify_Delaunay(exact).ties.size(), ties);
      const Exact again = reloaded(exact);
      EXPECT_EQ(IT::certify_Delaunay(again).ties.size(), ties);
      EXPECT_EQ(text_of(again), text_of(exact));
      EXPECT_EQ(outcome(text_of(exact)), Outcome::valid);
    }
}

// Exact ties need the exact numbers of an octagon whose squared lengths contain the root of 2.
TEST(IO, an_octagon_is_kept)
{
  Delta_complex mesh = double_torus();
  auto square = mesh.add_property_map<Edge_index, Q_of_roots>("e:square", Q_of_roots(1)).first;
  const std::array<int, 5> a{2, 3, 4, 3, 2}, b{1, 2, 2, 2, 1};
  for(unsigned int d = 0; d < 5; ++d)
    square[Edge_index(4 + d)] = Q_of_roots(a[d], b[d], 2);
  const IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<Q_of_roots>> octagon(
    mesh, IT::parameters::squared_edge_length_map(square));
  EXPECT_EQ(IT::certify_Delaunay(reloaded(octagon)).ties.size(), 5u);
}

bool is_damaged_with_extension(const std::string& text)
{
  typedef IT::Exact_Euclidean_geometry_traits<Q_of_roots> Traits;
  std::istringstream stream(text);
  try {
    IT::read_intrinsic_triangulation<Traits>(stream);
    return false;
  } catch(const IT::File_format_error&) {
    return true;
  }
}

void expect_bad_number(const std::string& start, const std::string& bad)
{
  const std::string text = start + "exact squared_lengths\n0x1p+0\n0x1p+0\n" + bad + "\n";
  EXPECT_EQ(outcome(text), Outcome::bad_format) << bad;
  EXPECT_TRUE(is_damaged_with_extension(text)) << bad;
}

TEST(IO, damaged_exact_numbers)
{
  const std::string start = text_of(triangulation(glue({{1, 2, 3}, {-1, -2, -3}}), {1, 1, 1}));
  const std::string lengths = "exact lengths\n";
  const std::string squares = start.substr(0, start.size() - lengths.size());
  EXPECT_EQ(squares + lengths, start);
  EXPECT_EQ(outcome(squares + "exact squared_lengths\n0x1p+0\n0x1p+0\n0x1p+0\n"), Outcome::valid);
  EXPECT_EQ(outcome(squares + "exact squared_lengths\n1/1\n3/3\n1/1\n"), Outcome::valid);
  EXPECT_EQ(outcome(squares + "exact squared_lengths\n0x1p+0\n0x1p+0\n0x1p+1\n"),
            Outcome::bad_triangulation);
  for(const char* bad :
      {"", "0", "1/", "/1", "1/0", "1/000", "-1/1", "1/-1", "1/1/1", "1 /1", "0x"})
    expect_bad_number(squares, bad);
  for(const char* bad : {"0xinf", "0xnan", "1/1x", "1.5/1", "1/1 1/1", "1/1 1/1 -2/1",
                         "1/1 1/1 2/0", "1/1 1/1 2/1 1/1", "1/1 - 2/1"})
    expect_bad_number(squares, bad);
  EXPECT_TRUE(
    is_damaged_with_extension(squares + "exact squared_lengths\n1/1\n1/1\n1/1 -1/1 2/1\n"));
  for(const char* bad : {"exact positions\n", "exact\n", "lengths\n", "\n", ""})
    EXPECT_EQ(outcome(squares + bad), Outcome::bad_format) << bad;
}

TEST(IO, positions_that_do_not_fit_the_lengths)
{
  const Lines lines = lines_of(text_of(Triangulation(tetrahedron())));
  const auto first = std::find(lines.begin(), lines.end(), "exact positions") + 1;
  ASSERT_EQ(lines.end() - first, 4);
  for(auto l = first; l != lines.end(); ++l) {
    Lines changed = lines;
    changed[std::size_t(l - lines.begin())] = "0x1.8p+3 -0x1p+0 0x0p+0";
    EXPECT_EQ(outcome(joined(changed, '\n')), Outcome::bad_triangulation);
  }
}

#ifdef __linux__
// A short file that announces many elements must not allocate memory for them.
TEST(IO, promises_take_no_memory)
{
  const auto peak = [] { // in kilobytes
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  for(const char* counts : {"40000000 6 4", "4 20000000 4", "4 6 40000000"}) {
    const long before = peak();
    EXPECT_EQ(outcome(std::string("intrinsic_triangulation 3\n") + counts + "\n0\n"),
              Outcome::bad_format);
    EXPECT_LT(peak() - before, 50000) << counts;
  }
}
#endif

// Defines number formats of a stream or a program, which must not affect files.
struct Strange_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

TEST(IO, locale_does_not_matter)
{
  Triangulation t(embedded_torus(6, 5));
  IT::make_Delaunay(t);
  const std::string text = text_of(t);
  const std::locale strange(std::locale::classic(), new Strange_numbers);
  std::stringstream stream;
  stream.imbue(strange);
  EXPECT_TRUE(IT::write_intrinsic_triangulation(stream, t));
  EXPECT_TRUE(stream.str() == text);
  std::istringstream is(text);
  is.imbue(strange);
  expect_equal(IT::read_intrinsic_triangulation(is), t);
}

TEST(IO, flags_of_the_stream_do_not_matter)
{
  const Triangulation t(embedded_torus(6, 5));
  std::ostringstream os;
  os << std::hex << std::showpos << std::showbase;
  EXPECT_TRUE(IT::write_intrinsic_triangulation(os, t));
  EXPECT_TRUE(os.str() == text_of(t));
}

TEST(IO, stream_that_fails)
{
  std::ostringstream os;
  os.setstate(std::ios::failbit);
  EXPECT_FALSE(IT::write_intrinsic_triangulation(os, Triangulation(tetrahedron())));
}

// One stream contains two triangulations.
TEST(IO, reads_no_further_than_the_end)
{
  Triangulation a(embedded_torus(5, 4)), b(tetrahedron());
  IT::make_Delaunay(a);
  std::stringstream stream(text_of(a) + text_of(b));
  expect_equal(IT::read_intrinsic_triangulation(stream), a);
  expect_equal(IT::read_intrinsic_triangulation(stream), b);
}

} // namespace Test_io
