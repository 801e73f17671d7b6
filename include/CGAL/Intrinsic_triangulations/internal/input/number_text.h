// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_TEXT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_TEXT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <charconv>
#include <cstddef>
#include <istream>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The shortest hexadecimal text of a finite positive number, with the prefix 0x, whatever the
// locale.
template <typename FT>
std::string hexadecimal_text(const FT& x)
{
  static_assert(std::is_floating_point<FT>::value, "only floating point numbers can be written");
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), x, std::chars_format::hex).ptr;
  return "0x" + std::string(buffer, end);
}

// Reads a text line by line, and numbers from a line; says in which line something is wrong.
class Line_reader
{
public:
  explicit Line_reader(std::istream& is) : m_is(is) {}

  // goes on to the next line, which must exist
  void next_line()
  {
    ++m_number;
    m_line.clear();
    if(!std::getline(m_is, m_line))
      fail("the file ends too early");
    m_position = m_line.data();
  }

  // the line must have nothing more
  void end_line()
  {
    skip_blanks();
    if(m_position != end())
      fail("there is more than expected: '" + std::string(m_position, end()) + "'");
  }

  void expect(const std::string& line)
  {
    if(m_line != line)
      fail("'" + line + "' expected");
  }

  // the next number of the line, which must be within the bounds
  template <typename Integer>
  Integer integer(const Integer& least, const Integer& greatest)
  {
    Integer value{};
    parse([&](const char* from) { return std::from_chars(from, end(), value); }, "an integer");
    if(value < least || value > greatest)
      fail("number " + std::to_string(value) + " is out of range");
    return value;
  }

  // the next number of the line, in hexadecimal
  template <typename FT>
  FT hexadecimal()
  {
    FT value{};
    skip_blanks();
    if(end() - m_position < 2 || m_position[0] != '0' || m_position[1] != 'x')
      fail("a number that starts with 0x expected");
    m_position += 2;
    parse(
      [&](const char* from) { return std::from_chars(from, end(), value, std::chars_format::hex); },
      "a hexadecimal number");
    return value;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw File_format_error(message, m_number);
  }

private:
  const char* end() const { return m_line.data() + m_line.size(); }

  void skip_blanks()
  {
    while(m_position != end() && *m_position == ' ')
      ++m_position;
  }

  template <typename Parse>
  void parse(const Parse& parse, const char* what)
  {
    skip_blanks();
    const auto result = parse(m_position);
    if(result.ec != std::errc())
      fail(std::string(what) + " expected");
    m_position = result.ptr;
  }

  std::istream& m_is;
  std::string m_line;
  const char* m_position = nullptr;
  std::size_t m_number = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_TEXT_H
