// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_UNKNOWN_WORDS_H
#define INTRINSIC_UNKNOWN_WORDS_H

#include <CLI/CLI.hpp>

#include <string>

// Describes, after a call could not be parsed, which command or option does not exist, and which
// one is similar. Returns an empty text if all exist.
std::string unknown_word(const CLI::App& app, int argc, const char* const* argv);

// Describes, after a call could not be parsed, the words that no option takes, in their order.
// Names a repeatable option if two values follow it. Returns an empty text if each word is used.
std::string unexpected_words(const CLI::App& app, int argc, const char* const* argv);

// Returns whether the option takes one value at a time, and can be given several times.
bool is_repeatable(const CLI::Option& option);

#endif // INTRINSIC_UNKNOWN_WORDS_H
