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

#endif // INTRINSIC_UNKNOWN_WORDS_H
