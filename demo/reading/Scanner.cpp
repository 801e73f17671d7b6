// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Scanner.h"

#include "Program_error.h"
#include "reading/text_encoding.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <system_error>

namespace fs = std::filesystem;

namespace {

// This character replaces the end of a continued line, which counts as a line.
constexpr char joint = '\v';

constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }
constexpr bool is_space(char c) { return c == '\n' || is_blank(c); }

// Returns whether a character may follow a number. A comment, the other indices of a corner and a
// tag may follow directly.
constexpr bool may_follow_number(char c) { return is_space(c) || c == '#' || c == '/' || c == '<'; }

// Returns a word in one line of printable characters.
std::string quoted(std::string_view word)
{
  std::string result(word.substr(0, 32));
  for(char& c : result)
    if(c < ' ' || c > '~')
      c = '?';
  return "'" + result + (word.size() > 32 ? "...'" : "'");
}

// Returns the bytes, also of files that are not regular and have no size.
std::string file_bytes(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  if(!file)
    throw Program_error(path.string() + ": cannot be opened; are you allowed to read it?");
  std::string result;
  std::error_code none;
  std::size_t block =
    static_cast<std::size_t>(fs::is_regular_file(path) ? fs::file_size(path, none) : 0) + 1;
  while(file) {
    const std::size_t size = result.size();
    result.resize(size + block);
    file.read(result.data() + size, static_cast<std::streamsize>(block));
    result.resize(size + static_cast<std::size_t>(file.gcount()));
    block = (std::max)(result.size(), std::size_t(1) << 16);
  }
  if(file.bad())
    throw Program_error(path.string() + ": cannot be read");
  return result;
}

} // namespace

std::optional<double> finite_number(const std::string& text)
{
  const bool is_decimal = text.find_first_not_of("0123456789.+-eE") == text.npos;
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  return text.empty() || !is_decimal || *end != '\0' || !std::isfinite(result)
           ? std::nullopt
           : std::optional<double>(result);
}

std::string file_content(const fs::path& path)
{
  if(!fs::exists(path))
    throw Program_error(path.string() + ": no such file");
  if(fs::is_directory(path))
    throw Program_error(path.string() + ": is a directory");
  return plain_text(file_bytes(path));
}

Scanner::Scanner(const fs::path& path)
  : m_path(path), m_bytes(file_content(path)), m_position(m_bytes.data())
{
  if(m_bytes.empty())
    fail_as_a_whole("is empty");
}

void Scanner::skip_blanks()
{
  while(m_position != end() && is_blank(*m_position))
    ++m_position;
}

bool Scanner::at_line_end(char comment)
{
  skip_blanks();
  return m_position == end() || *m_position == '\n' || *m_position == comment;
}

void Scanner::skip_line()
{
  const void* const newline = std::memchr(m_position, '\n', remaining());
  m_position = newline == nullptr ? end() : static_cast<Place>(newline) + 1;
}

void Scanner::skip_space()
{
  while(m_position != end() && is_space(*m_position))
    ++m_position;
}

void Scanner::skip_comments(char comment)
{
  for(skip_space(); m_position != end() && *m_position == comment; skip_space())
    skip_line();
}

void Scanner::expect_end(const std::string& last, char comment)
{
  if(m_is_binary && !at_end())
    fail_as_a_whole("has " + std::to_string(remaining()) + " bytes behind " + last +
                    ", which ends the file; remove what follows");
  skip_comments(comment);
  if(!at_end())
    fail(quoted(rest_of_word()) + " follows " + last +
         ", which ends the file; remove what follows");
}

std::string_view Scanner::rest_of_word() const
{
  const Place last = std::find_if(m_position, end(), is_space);
  return {m_position, static_cast<std::size_t>(last - m_position)};
}

std::string_view Scanner::word()
{
  skip_blanks();
  const std::string_view result = rest_of_word();
  m_position += result.size();
  return result;
}

// Most words differ in their first character, so their ends are not searched.
template <class Is_equal>
bool Scanner::accept_if(std::string_view expected, const Is_equal& is_equal)
{
  skip_blanks();
  const std::size_t n = expected.size();
  if(remaining() < n || !std::equal(expected.begin(), expected.end(), m_position, is_equal) ||
     (remaining() > n && !is_space(m_position[n])))
    return false;
  m_position += n;
  return true;
}

bool Scanner::accept(std::string_view expected) { return accept_if(expected, std::equal_to<>()); }

bool Scanner::accept_in_any_case(std::string_view expected)
{
  return accept_if(expected, [](char lower, char c) {
    return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower);
  });
}

void Scanner::join_lines(char comment)
{
  for(std::size_t i = m_bytes.find('\\'); i != m_bytes.npos; i = m_bytes.find('\\', i + 1)) {
    const std::size_t end = m_bytes.find_first_not_of(" \t\r", i + 1);
    const std::size_t before = m_bytes.find_last_of(std::string{'\n', joint, comment}, i);
    if(end == m_bytes.npos || m_bytes[end] != '\n' ||
       (before != m_bytes.npos && m_bytes[before] == comment))
      continue;
    m_bytes[i] = ' ';
    m_bytes[end] = joint;
  }
}

std::string_view Scanner::take_rest_of_word()
{
  const std::string_view result = rest_of_word();
  m_position += result.size();
  return result;
}

std::vector<double> Scanner::numbers()
{
  std::vector<double> result;
  for(std::string_view w = word(); !w.empty(); w = word()) {
    w.remove_prefix(w.size() > 1 && w[0] == '+' && w[1] != '-');
    double x = 0;
    const auto [last, error] = std::from_chars(w.data(), w.data() + w.size(), x);
    if(error != std::errc() || last != w.data() + w.size() || !std::isfinite(x))
      break;
    result.push_back(x);
  }
  return result;
}

std::string_view Scanner::until(std::string_view last)
{
  const std::string_view rest(m_position, remaining());
  const std::size_t size = rest.find(last);
  if(size == std::string_view::npos)
    fail_as_a_whole("ends too early; it is not complete");
  m_position += size + last.size();
  return rest.substr(0, size);
}

// Tiny numbers become zero or the least positive number.
template <class Number>
Number Scanner::value_beyond_range(std::string_view digits) const
{
  const double x = std::strtod(std::string(digits).c_str(), nullptr);
  return static_cast<Number>(x);
}

template <class Number>
Number Scanner::number()
{
  skip_blanks();
  const bool has_plus = remaining() > 1 && m_position[0] == '+' && m_position[1] != '-';
  const Place first = m_position + has_plus;
  Number result{};
  const auto [last, error] = std::from_chars(first, end(), result);
  if(error == std::errc::result_out_of_range)
    result = value_beyond_range<Number>({first, static_cast<std::size_t>(last - first)});
  else if(error != std::errc() || (last != end() && !may_follow_number(*last)))
    fail(at_line_end() ? "a number is missing" : quoted(rest_of_word()) + " is not a number");
  if(!std::isfinite(result))
    fail(quoted(rest_of_word()) + " is not a finite number");
  m_position = last;
  return result;
}

template float Scanner::number<float>();
template double Scanner::number<double>();

std::int64_t Scanner::integer()
{
  skip_blanks();
  const Place start = m_position;
  std::int64_t result = 0;
  const auto [last, error] = std::from_chars(start, end(), result);
  if(error == std::errc() && (last == end() || may_follow_number(*last))) {
    m_position = last;
    return result;
  }
  const double x = number<double>();
  if(x != std::floor(x) || std::abs(x) > 1e15) {
    m_position = start;
    fail(quoted(rest_of_word()) + " is not an integer");
  }
  return static_cast<std::int64_t>(x);
}

std::size_t Scanner::count()
{
  const Place start = m_position;
  const std::int64_t n = integer();
  if(n < 0) {
    m_position = start;
    fail("a number of elements is negative");
  }
  return static_cast<std::size_t>(n);
}

void Scanner::fail(const std::string& reason) const
{
  if(m_is_binary)
    fail_as_a_whole("cannot be read: byte " + std::to_string(m_position - m_bytes.data()) + ": " +
                    reason);
  if(m_position == end())
    fail_as_a_whole("ends too early; it is not complete");
  const std::ptrdiff_t line =
    1 + std::count_if(m_bytes.data(), m_position, [](char c) { return c == '\n' || c == joint; });
  fail_as_a_whole("line " + std::to_string(line) + " cannot be understood: " + reason);
}

void Scanner::fail_as_a_whole(const std::string& reason) const
{
  throw Program_error(m_path.string() + ": " + reason);
}
