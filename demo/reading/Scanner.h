// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SCANNER_H
#define INTRINSIC_SCANNER_H

#include "writing/byte_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Returns the number in a text, or nothing if it is not a finite decimal number.
std::optional<double> finite_number(const std::string& text);

// Returns the text of a file without a byte-order mark, or the bytes of a binary file.
// Throws Program_error if the path names no file, or the file cannot be read.
std::string file_content(const std::filesystem::path& path);

// Reads the bytes of a file in their order. Reading never exceeds their end, whatever they contain.
// All functions that read throw Program_error, with the line in a text, if they do not find the
// expected content.
class Scanner
{
public:
  // Reads the file, without a byte-order mark. Throws Program_error if this is impossible, or it is
  // empty.
  explicit Scanner(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return m_path; }
  std::string_view bytes() const { return m_bytes; }

  std::size_t remaining() const { return static_cast<std::size_t>(end() - m_position); }
  std::size_t size() const { return m_bytes.size(); }
  bool at_end() const { return m_position == end(); }

  // ---- Text: numbers and words between blanks, in lines ----

  // Returns whether the rest of the line is empty, or a comment if a character starts comments.
  bool at_line_end(char comment = '\n');

  void skip_line();

  // Skips to the next word, in this line or in another.
  void skip_space();

  // Skips to the next word that is in no comment.
  void skip_comments(char comment);

  // Returns whether the next characters are `text`.
  bool begins_with(std::string_view text) const
  {
    return std::string_view(m_position, remaining()).substr(0, text.size()) == text;
  }

  // Checks that only blanks and comments, and no byte in a binary file, follow `last`, which ends
  // it.
  void expect_end(const std::string& last, char comment = '\n');

  // Returns the next word of the line, or an empty text.
  std::string_view word();

  // Returns whether the next word is this one, and reads it then.
  bool accept(std::string_view expected);

  // Accepts a word like accept(). `expected` is in lower case, but capital letters are accepted,
  // too.
  bool accept_in_any_case(std::string_view expected);

  // Joins lines: a line that ends with a backslash continues in the next one, except in comments.
  void join_lines(char comment);

  // Returns the next number in the line, which is finite; as `float` or `double`.
  template <class Number>
  Number number();

  // Returns the next integer in the line. A decimal point and zeros are allowed.
  std::int64_t integer();

  // Returns the next nonnegative integer in the line.
  std::size_t count();

  // Returns the characters directly after the last number or word, up to the next blank.
  std::string_view take_rest_of_word();

  // Returns the finite numbers that come next in the line.
  std::vector<double> numbers();

  // Returns the text before the next `last`, which is read, too.
  std::string_view until(std::string_view last);

  // ---- Binary ----

  // Returns the next bytes as a number, the least significant one first unless `is_big_endian`.
  template <class Number>
  Number binary(bool is_big_endian)
  {
    expect_bytes(sizeof(Number));
    Bytes_of<Number> bytes;
    std::copy_n(m_position, sizeof(Number), bytes.begin());
    m_position += sizeof(Number);
    return number_of_bytes<Number>(bytes, is_big_endian);
  }

  void skip_bytes(std::size_t n)
  {
    expect_bytes(n);
    m_position += n;
  }

  // Stops to count lines.
  void set_binary() { m_is_binary = true; }

  // ---- Places ----

  typedef const char* Place;
  Place place() const { return m_position; }
  void return_to(Place place) { m_position = place; }

  // Throws Program_error with the line or, unless this is a text, the byte that is being read.
  [[noreturn]] void fail(const std::string& reason) const;

  // Throws Program_error about the file as a whole.
  [[noreturn]] void fail_as_a_whole(const std::string& reason) const;

private:
  const char* end() const { return m_bytes.data() + m_bytes.size(); }

  void expect_bytes(std::size_t n) const
  {
    if(remaining() < n)
      fail_as_a_whole("ends too early; it is not complete");
  }

  void skip_blanks();
  std::string_view rest_of_word() const;
  // Reads the next word if its characters equal the characters of `expected`.
  template <class Is_equal>
  bool accept_if(std::string_view expected, const Is_equal& is_equal);
  template <class Number>
  Number value_beyond_range(std::string_view digits) const;

  std::filesystem::path m_path;
  std::string m_bytes;
  Place m_position;
  bool m_is_binary = false;
};

#endif // INTRINSIC_SCANNER_H
