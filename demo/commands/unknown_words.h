// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_UNKNOWN_WORDS_H
#define INTRINSIC_UNKNOWN_WORDS_H

#include <CLI/CLI.hpp>

#include <string>

// After a call could not be parsed: which command or option in it does not exist, and which is
// meant. Empty if all exist.
std::string unknown_word(const CLI::App& app, int argc, const char* const* argv);

#endif // INTRINSIC_UNKNOWN_WORDS_H
