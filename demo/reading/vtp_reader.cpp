// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Strip_splitter.h"
#include "reading/format_readers.h"
#include "reading/inflate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace {

// Stores the text between < and >.
struct Tag
{
  std::string_view text;

  // Returns the name; ends of elements begin with a slash.
  std::string_view name() const { return text.substr(0, text.find_first_of(" \t\r\n")); }

  bool is_empty_element() const { return !text.empty() && text.back() == '/'; }

  // Returns the attribute with this key, or an empty text.
  std::string_view attribute(const std::string& key) const
  {
    for(std::size_t i = text.find(key); i != text.npos; i = text.find(key, i + 1)) {
      const std::size_t first = i + key.size() + 2;
      if(i == 0 || text.find_first_of(" \t\r\n", i - 1) != i - 1 || first > text.size() ||
         text[first - 2] != '=' || (text[first - 1] != '"' && text[first - 1] != '\''))
        continue;
      const std::string_view rest = text.substr(first);
      return rest.substr(0, rest.find(text[first - 1]));
    }
    return {};
  }
};

// Decodes the bytes of base64, one at a time.
class Base64_decoder
{
public:
  explicit Base64_decoder(Scanner& in) : m_in(in) {}

  char next()
  {
    if(m_size == 0)
      read_group();
    --m_size;
    m_bits <<= 8;
    return static_cast<char>((m_bits >> 24) & 0xff);
  }

private:
  static std::uint32_t value(char c)
  {
    constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    return static_cast<std::uint32_t>(digits.find(c));
  }

  // Reads four digits, one or two of them possibly padding, which are three bytes.
  void read_group()
  {
    m_bits = 0;
    m_size = 3;
    for(int k = 0; k < 4; ++k) {
      m_in.skip_space();
      const char c = m_in.binary<char>(false);
      if(value(c) > 63 && c != '=')
        m_in.fail("a character is not of base64");
      m_size -= c == '=';
      m_bits = (m_bits << 6) | (value(c) & 63);
    }
    if(m_size < 1)
      m_in.fail("a number is missing");
  }

  Scanner& m_in;
  std::uint32_t m_bits = 0; // the next byte is below the highest one
  int m_size = 0;           // of the bytes that have been read ahead
};

struct Vtp_number
{
  double value;
  Scanner::Place place;
};

// Stores cells as VTK does: the points of all cells, and the end of each cell.
struct Vtp_cells
{
  std::vector<Vtp_number> points;
  std::vector<Vtp_number> ends;
};

// Reads polygons and strips or, on request, lines in place of them. Indices of points and ends of
// cells refer to a piece of the file.
class Vtp_reader
{
public:
  Vtp_reader(Scanner& in, Polygon_soup& soup, Polygons* lines)
    : m_in(in), m_soup(soup), m_lines(lines)
  {}

  void operator()()
  {
    expect_poly_data();
    Tag tag = next_tag();
    for(; tag.name() != "/VTKFile" && tag.name() != "AppendedData"; tag = next_tag())
      read(tag);
    if(tag.name() == "AppendedData")
      skip_to_end();
    expect_end();
    for(const auto& [name, array] : m_arrays)
      add_data(name, array);
  }

private:
  static constexpr std::string_view last_tag = "</VTKFile>";

  // Stores an array of points, from all pieces.
  struct Point_array
  {
    std::size_t components;
    std::vector<double> numbers;
  };

  // Skips to the next tag that is not a comment.
  Tag next_tag()
  {
    for(;;) {
      m_in.until("<");
      m_tag = m_in.place();
      if(const std::string_view text = m_in.until(">"); text.substr(0, 3) != "!--")
        return {text};
      m_in.return_to(m_tag);
      m_in.until("-->");
    }
  }

  // Skips appended numbers, because raw numbers may contain any byte.
  void skip_to_end()
  {
    const std::size_t last = m_in.bytes().rfind(last_tag);
    if(last == std::string_view::npos)
      m_in.fail_as_a_whole("ends too early; it is not complete");
    m_in.return_to(m_in.bytes().data() + last + last_tag.size());
  }

  // Checks that only comments follow the last tag.
  void expect_end()
  {
    for(m_in.skip_space(); m_in.begins_with("<!--"); m_in.skip_space())
      m_in.until("-->");
    m_in.expect_end(std::string(last_tag));
  }

  [[noreturn]] void fail_at(Scanner::Place place, const std::string& what)
  {
    m_in.return_to(place);
    m_in.fail(what);
  }

  void expect_poly_data()
  {
    Tag tag = next_tag();
    if(tag.name() == "?xml")
      tag = next_tag();
    if(tag.name() != "VTKFile" || tag.attribute("type") != "PolyData")
      fail_at(m_tag, "<VTKFile type=\"PolyData\"> expected at the beginning");
    m_is_big_endian = tag.attribute("byte_order") == "BigEndian";
    m_has_long_sizes = tag.attribute("header_type") == "UInt64";
    m_compressor = tag.attribute("compressor");
  }

  void read(const Tag& tag)
  {
    constexpr std::string_view sections[] = {"Points", "Lines",     "Polys",   "Strips",
                                             "Verts",  "PointData", "CellData"};
    const auto is_section = [&](std::string_view name) {
      return std::find(std::begin(sections), std::end(sections), name) != std::end(sections);
    };
    if(tag.name() == "Piece")
      m_points = m_soup.points.size();
    else if(tag.name() == "/Piece")
      end_piece();
    else if(is_section(tag.name())) {
      m_section = tag.is_empty_element() ? "" : tag.name();
      if(m_section == "PointData")
        m_roles = {tag.attribute("TCoords"), tag.attribute("Normals")};
    } else if(is_section(tag.name().substr(0, 1) == "/" ? tag.name().substr(1) : ""))
      m_section = {};
    else if(tag.name() == "DataArray")
      read_array(tag);
  }

  // ---- Cells ----

  void end_piece()
  {
    if(m_lines != nullptr)
      for_each_cell(m_cells["Lines"], "line", [&](const auto& cell) { m_lines->push_back(cell); });
    for_each_cell(m_cells["Polys"], "face",
                  [&](const auto& cell) { m_soup.polygons.push_back(cell); });
    for_each_cell(m_cells["Strips"], "strip", [&](const auto& cell) {
      Strip_splitter splitter(m_soup.polygons);
      for(const std::size_t i : cell)
        splitter.add_corner(i);
    });
    m_cells.clear();
  }

  template <class Use>
  void for_each_cell(const Vtp_cells& cells, const std::string& what, const Use& use)
  {
    if((cells.ends.empty() ? 0 : cells.ends.back().value) !=
       static_cast<double>(cells.points.size()))
      fail_at(m_tag, "the last of the offsets of " + what + "s is not the number of their points");
    std::size_t i = 0;
    for(const Vtp_number& end : cells.ends) {
      std::vector<std::size_t> cell;
      for(; static_cast<double>(i) < end.value; ++i)
        cell.push_back(checked_index(cells.points[i], what));
      use(cell);
    }
  }

  std::size_t checked_index(const Vtp_number& index, const std::string& what)
  {
    const std::size_t n = m_soup.points.size() - m_points;
    if(index.value >= static_cast<double>(n))
      fail_at(index.place, "a " + what + " names a point that does not exist; there are " +
                             std::to_string(n) + " in this piece");
    return m_points + static_cast<std::size_t>(index.value);
  }

  // ---- Arrays ----

  void read_array(const Tag& tag)
  {
    if(m_section == "Points")
      read_points(tag);
    else if(m_section == "PointData" && m_lines == nullptr)
      read_point_data(tag);
    else if(m_lines == nullptr ? m_section == "Polys" || m_section == "Strips"
                               : m_section == "Lines") {
      if(tag.attribute("Name") == "connectivity")
        read_indices(tag, m_cells[m_section].points);
      else if(tag.attribute("Name") == "offsets")
        read_ends(tag, m_cells[m_section].ends);
    }
  }

  void read_points(const Tag& tag)
  {
    if(tag.attribute("NumberOfComponents") != "3")
      fail_at(m_tag, "points do not have three coordinates each");
    std::vector<double> x;
    for_each_number(tag, [&](const Vtp_number& number) {
      x.push_back(number.value);
      if(x.size() < 3)
        return;
      m_soup.points.emplace_back(x[0], x[1], x[2]);
      x.clear();
    });
    if(!x.empty())
      m_in.fail("a number is missing");
  }

  void read_indices(const Tag& tag, std::vector<Vtp_number>& indices)
  {
    for_each_number(tag, [&](const Vtp_number& number) {
      if(number.value != std::floor(number.value))
        fail_at(number.place, "an index of a point or an offset is not an integer");
      if(number.value < 0)
        fail_at(number.place, "an index of a point or an offset is negative");
      indices.push_back(number);
    });
  }

  void read_ends(const Tag& tag, std::vector<Vtp_number>& ends)
  {
    read_indices(tag, ends);
    for(std::size_t i = 1; i < ends.size(); ++i)
      if(ends[i].value < ends[i - 1].value)
        fail_at(ends[i].place, "the offsets of cells are not ascending");
  }

  void read_point_data(const Tag& tag)
  {
    const std::string_view components = tag.attribute("NumberOfComponents");
    const std::string_view given = tag.attribute("Name");
    const std::string name(!given.empty() && given == m_roles[0]   ? "texcoord"
                           : !given.empty() && given == m_roles[1] ? "normal"
                                                                   : given);
    std::size_t n = 1;
    std::from_chars(components.data(), components.data() + components.size(), n);
    std::vector<double>& numbers = m_arrays.emplace(name, Point_array{n, {}}).first->second.numbers;
    for_each_number(tag, [&](const Vtp_number& number) { numbers.push_back(number.value); });
  }

  // Adds a function, or data of corners by their names.
  void add_data(const std::string& name, const Point_array& array)
  {
    const std::size_t points = m_soup.points.size(), n = array.components;
    if(n == 1)
      m_soup.data.functions.push_back({name, array.numbers});
    else if(n == corner_dimension(name) && array.numbers.size() == n * points)
      add_corner_data(
        name, n, m_soup.polygons, points,
        [&](std::size_t c) -> Corner_data_builder::Coordinates {
          const double* const x = &array.numbers[n * m_soup.polygons.corners()[c]];
          return {x[0], x[1], n == 3 ? x[2] : 1};
        },
        m_soup.data);
  }

  // ---- Numbers: text, base64 or bytes behind all tags ----

  template <class Use>
  void for_each_number(const Tag& tag, const Use& use)
  {
    const std::string_view format = tag.attribute("format");
    if(format != "ascii" && !format.empty())
      return read_encoded(tag, format, use);
    for(m_in.skip_space(); !tag.is_empty_element() && !m_in.at_line_end('<'); m_in.skip_space()) {
      const Scanner::Place place = m_in.place();
      use(Vtp_number{m_in.number<double>(), place});
    }
  }

  template <class Use>
  void read_encoded(const Tag& tag, std::string_view format, const Use& use)
  {
    const Scanner::Place start = m_in.place();
    if(!m_compressor.empty() && (!can_inflate || m_compressor != "vtkZLibDataCompressor"))
      fail_at(m_tag, "the numbers are compressed by " + std::string(m_compressor) +
                       "; save the file without compression");
    bool is_raw = false;
    if(format == "appended")
      is_raw = go_to_appended(tag);
    else if(format != "binary")
      fail_at(m_tag, "the format of numbers is none of ascii, binary and appended");
    if(is_raw)
      read_array_of_bytes(
        tag, [&] { return m_in.binary<char>(false); }, use);
    else
      read_array_of_bytes(
        tag, [decoder = Base64_decoder(m_in)]() mutable { return decoder.next(); }, use);
    m_in.return_to(start);
  }

  // Reads an array. `next()` returns the next byte. The first bytes contain the number of the
  // others or, before compressed blocks, the number and sizes of blocks.
  template <class Next, class Use>
  void read_array_of_bytes(const Tag& tag, Next next, const Use& use)
  {
    if(m_compressor.empty())
      return read_bytes(tag, size(next), next, use);
    const std::string bytes = decompressed_blocks(next);
    read_bytes(
      tag, bytes.size(), [byte = bytes.begin()]() mutable { return *byte++; }, use);
  }

  template <class Next>
  std::uint64_t size(Next& next) const
  {
    return m_has_long_sizes ? number<std::uint64_t>(next) : number<std::uint32_t>(next);
  }

  // Returns the bytes of all blocks. The last block has another size, unless this size is zero.
  template <class Next>
  std::string decompressed_blocks(Next& next)
  {
    const Scanner::Place place = m_tag;
    const std::uint64_t blocks = size(next), full = size(next), last = size(next);
    std::vector<std::uint64_t> sizes;
    while(sizes.size() < blocks)
      sizes.push_back(size(next));
    std::string result;
    for(std::uint64_t i = 0; i < blocks; ++i) {
      std::string block;
      while(block.size() < sizes[i])
        block.push_back(next());
      const std::string bytes = inflated(block, i + 1 == blocks && last > 0 ? last : full);
      if(bytes.empty())
        fail_at(place, "the compressed numbers are damaged");
      result += bytes;
    }
    return result;
  }

  // Skips to the appended bytes, and returns whether they are not in base64.
  bool go_to_appended(const Tag& tag)
  {
    const std::string_view offset = tag.attribute("offset");
    std::size_t n = 0;
    if(std::from_chars(offset.data(), offset.data() + offset.size(), n).ec != std::errc())
      fail_at(m_tag, "the offset of appended numbers is missing");
    m_in.until("<AppendedData");
    const bool is_raw = Tag{m_in.until(">")}.attribute("encoding") == "raw";
    m_in.until("_");
    m_in.skip_bytes(n);
    return is_raw;
  }

  // Reads the numbers that so many bytes contain.
  template <class Next, class Use>
  void read_bytes(const Tag& tag, std::uint64_t size, Next next, const Use& use)
  {
    const Scanner::Place place = m_tag;
    const auto read_all = [&](auto zero) {
      for(std::uint64_t i = 0; i < size / sizeof(zero); ++i)
        use(Vtp_number{static_cast<double>(number<decltype(zero)>(next)), place});
    };
    const std::string_view type = tag.attribute("type");
    if(type == "Float64")
      read_all(double());
    else if(type == "Float32")
      read_all(float());
    else if(type == "Int64" || type == "UInt64")
      read_all(std::int64_t());
    else if(type == "Int32")
      read_all(std::int32_t());
    else if(type == "UInt32")
      read_all(std::uint32_t());
    else if(type == "Int16")
      read_all(std::int16_t());
    else if(type == "UInt16")
      read_all(std::uint16_t());
    else if(type == "Int8")
      read_all(std::int8_t());
    else if(type == "UInt8")
      read_all(std::uint8_t());
    else
      fail_at(place, "the type of numbers '" + std::string(type) +
                       "' is unknown; it must be a type of VTK, such as Float64");
  }

  template <class Number, class Next>
  Number number(Next& next) const
  {
    Bytes_of<Number> bytes;
    for(char& byte : bytes)
      byte = next();
    return number_of_bytes<Number>(bytes, m_is_big_endian);
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  Polygons* m_lines;
  bool m_is_big_endian = false, m_has_long_sizes = false;
  std::string_view m_compressor; // empty if numbers are not compressed
  Scanner::Place m_tag;
  std::string_view m_section;                // what arrays belong to
  std::array<std::string_view, 2> m_roles{}; // names of the texture and of normals
  std::size_t m_points = 0;                  // before those of the piece
  std::map<std::string_view, Vtp_cells> m_cells;
  std::map<std::string, Point_array> m_arrays;
};

} // namespace

void read_vtp(Scanner& in, Polygon_soup& soup, Polygons* lines) { Vtp_reader(in, soup, lines)(); }
