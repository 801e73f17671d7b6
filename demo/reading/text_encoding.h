// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TEXT_ENCODING_H
#define INTRINSIC_TEXT_ENCODING_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

// Returns a text or a line of it, without the byte-order mark of UTF-8.
inline std::string without_byte_order_mark(std::string text)
{
  if(text.compare(0, 3, "\xef\xbb\xbf") == 0)
    text.erase(0, 3);
  return text;
}

// Returns the text of UTF-16 with a byte-order mark, in which `first` is the position of the lower
// bytes. Characters beyond ASCII become question marks.
inline std::string text_of_utf16(const std::string& bytes, std::size_t first)
{
  std::string result;
  for(std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const bool is_ascii = bytes[i + 1 - first] == '\0' && (bytes[i + first] & 0x80) == 0;
    result += is_ascii ? bytes[i + first] : '?';
  }
  return result;
}

// Returns the bytes of a file. A text loses its byte-order mark, and its lines end with line feeds.
// A binary file is unchanged.
inline std::string plain_text(std::string bytes)
{
  for(const std::size_t first : {0u, 1u})
    if(bytes.compare(0, 2, first == 0 ? "\xff\xfe" : "\xfe\xff") == 0 && bytes.size() > 3 &&
       bytes[3 - first] == '\0')
      bytes = text_of_utf16(bytes, first);
  bytes = without_byte_order_mark(std::move(bytes));
  if(bytes.find('\n') == bytes.npos && bytes.find('\0') == bytes.npos)
    std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  return bytes;
}

inline std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Returns the extension with its dot, in lower case.
inline std::string extension_of(const std::filesystem::path& path)
{
  return lower_case(path.extension().string());
}

#endif // INTRINSIC_TEXT_ENCODING_H
