// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_TEXT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_TEXT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the shortest hexadecimal text of a finite number, with the prefix 0x after the sign, in
// any locale.
template <typename FT>
std::string hexadecimal_text(const FT& x)
{
  static_assert(std::is_floating_point<FT>::value, "only floating point numbers can be written");
  char buffer[64];
  const auto end =
    std::to_chars(buffer, buffer + sizeof(buffer), std::abs(x), std::chars_format::hex).ptr;
  return (std::signbit(x) ? "-0x" : "0x") + std::string(buffer, end);
}

// Returns whether exact numbers of this type can be written.
template <typename K>
constexpr bool has_exact_text()
{
  return std::is_floating_point_v<K> || is_fraction<K>() || is_extension_of_fractions<K>();
}

// Returns fractions as numerator and denominator, and a + b sqrt(c) as the fractions a, b and c.
template <typename K>
std::string exact_text(const K& x)
{
  static_assert(has_exact_text<K>());
  if constexpr(std::is_floating_point_v<K>)
    return hexadecimal_text(x);
  else if constexpr(Is_extension<K>::value)
    return x.is_extended()
             ? exact_text(x.a0()) + ' ' + exact_text(x.a1()) + ' ' + exact_text(x.root())
             : exact_text(x.a0());
  else {
    typename Fraction_traits<K>::Numerator_type numerator;
    typename Fraction_traits<K>::Denominator_type denominator;
    typename Fraction_traits<K>::Decompose()(x, numerator, denominator);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << numerator << '/' << denominator;
    return text.str();
  }
}

// Reads a text line by line, and numbers from a line. Errors name the line.
class Line_reader
{
public:
  explicit Line_reader(std::istream& is) : m_is(is) {}

  // Reads the next line, which must exist.
  void next_line()
  {
    ++m_number;
    m_line.clear();
    if(!std::getline(m_is, m_line))
      fail("the file ends too early");
    m_position = m_line.data();
  }

  // Checks that the line has no further text.
  void end_line()
  {
    skip_blanks();
    if(m_position != end())
      fail("there is more than expected: '" + std::string(m_position, end()) + "'");
  }

  // Returns the number of the current line, counted from 1.
  std::size_t number() const { return m_number; }

  bool is(std::string_view line) const { return m_line == line; }

  void expect(std::string_view line) const
  {
    if(!is(line))
      fail("'" + std::string(line) + "' expected");
  }

  // Reads the next number of the line, which must be within the bounds.
  template <typename Integer>
  Integer integer(const Integer& least, const Integer& greatest)
  {
    Integer value{};
    parse([&](const char* from) { return std::from_chars(from, end(), value); }, "an integer");
    if(value < least || value > greatest)
      fail("number " + std::to_string(value) + " is out of range");
    return value;
  }

  // Reads the next number of the line, in hexadecimal.
  template <typename FT>
  FT hexadecimal()
  {
    FT value{};
    skip_blanks();
    const bool is_negative = next_is("-");
    if(!next_is("0x") || *m_position == '-')
      fail("a number that starts with 0x expected");
    parse(
      [&](const char* from) { return std::from_chars(from, end(), value, std::chars_format::hex); },
      "a hexadecimal number");
    return is_negative ? -value : value;
  }

  // Reads the positive number on the rest of the line, as `exact_text()` writes it, if the type can
  // represent it.
  template <typename K>
  std::optional<K> exact()
  {
    skip_blanks();
    if(m_line.find('/') == std::string::npos)
      return K(finite(hexadecimal<double>()));
    const Fraction_text a = fraction();
    skip_blanks();
    if(m_position == end())
      return exact<K>(a);
    const Fraction_text b = fraction(), c = fraction();
    return exact<K>(a, b, c);
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

  // Skips `text` if it comes next. Returns whether it does.
  bool next_is(std::string_view text)
  {
    const bool result = std::string_view(m_position, static_cast<std::size_t>(end() - m_position))
                          .substr(0, text.size()) == text;
    m_position += result ? text.size() : 0;
    return result;
  }

  struct Fraction_text
  {
    bool is_negative;
    std::string_view numerator, denominator;
  };

  Fraction_text fraction()
  {
    skip_blanks();
    Fraction_text result;
    result.is_negative = next_is("-");
    result.numerator = digits();
    if(!next_is("/"))
      fail("a fraction expected");
    result.denominator = digits();
    if(result.denominator.find_first_not_of('0') == std::string_view::npos)
      fail("the denominator is zero");
    return result;
  }

  template <typename K>
  static K to_number(const Fraction_text& text)
  {
    typedef Fraction_traits<K> Traits;
    const K absolute =
      typename Traits::Compose()(integer<typename Traits::Numerator_type>(text.numerator),
                                 integer<typename Traits::Denominator_type>(text.denominator));
    return text.is_negative ? K(-absolute) : absolute;
  }

  template <typename K>
  std::optional<K> exact(const Fraction_text& a) const
  {
    if(a.is_negative)
      fail("a positive number expected");
    if constexpr(is_fraction<K>())
      return to_number<K>(a);
    else if constexpr(is_extension_of_fractions<K>())
      return K(to_number<typename K::NT>(a));
    else
      return {};
  }

  template <typename K>
  std::optional<K> exact(const Fraction_text& a, const Fraction_text& b,
                         const Fraction_text& c) const
  {
    if(c.is_negative)
      fail("the root of a negative number");
    if constexpr(is_extension_of_fractions<K>()) {
      typedef typename K::NT NT;
      const K result(to_number<NT>(a), to_number<NT>(b), to_number<NT>(c));
      if(CGAL::sign(result) != CGAL::POSITIVE)
        fail("a positive number expected");
      return result;
    } else
      return {};
  }

  double finite(double x) const
  {
    if(!std::isfinite(x))
      fail("a finite number expected");
    return x;
  }

  std::string_view digits()
  {
    const std::string_view rest(m_position, static_cast<std::size_t>(end() - m_position));
    const std::string_view result =
      rest.substr(0, (std::min)(rest.find_first_not_of("0123456789"), rest.size()));
    if(result.empty())
      fail("digits expected");
    m_position += result.size();
    return result;
  }

  // Returns an integer of any size.
  template <typename Integer>
  static Integer integer(std::string_view digits)
  {
    std::istringstream is{std::string(digits)};
    is.imbue(std::locale::classic());
    Integer result;
    is >> result;
    return result;
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
