// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LINE_COUNTING_BUFFER_H
#define INTRINSIC_LINE_COUNTING_BUFFER_H

#include <cstddef>
#include <istream>
#include <streambuf>
#include <string>

// Hands a stream on line by line, so that whoever reads it can report how far it came.
class Line_counting_buffer : public std::streambuf
{
public:
  explicit Line_counting_buffer(std::istream& source) : m_source(source) {}

  // The line that is being read, starting from 1.
  std::size_t line() const { return m_line; }

  bool has_ended() const { return m_has_ended; }

protected:
  int_type underflow() override
  {
    if(!std::getline(m_source, m_text)) {
      m_has_ended = true;
      return traits_type::eof();
    }
    if(!m_source.eof())
      m_text += '\n';
    ++m_line;
    setg(m_text.data(), m_text.data(), m_text.data() + m_text.size());
    return m_text.empty() ? traits_type::eof() : traits_type::to_int_type(m_text.front());
  }

private:
  std::istream& m_source;
  std::string m_text;
  std::size_t m_line = 0;
  bool m_has_ended = false;
};

#endif // INTRINSIC_LINE_COUNTING_BUFFER_H
