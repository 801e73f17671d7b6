// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ATTEMPTS_H
#define INTRINSIC_ATTEMPTS_H

#include "commands/Command_run.h"

#include <functional>

// Returns what `compute()` returns, an exit code. What rounding makes impossible is computed again
// with longer edges, if triangles are almost flat; if that fails, too, the error is that of the
// surface as it is. A map that is no success is written if that is wanted and there is no other.
int attempt(Command_run& run, const std::function<int()>& compute);

// Returns what a command returns that is a class.
template <class Command, class Own_options>
int attempted(const Common_options& common, const Own_options& options)
{
  Command command(common, options);
  return attempt(command.command_run(), [&] { return command.run(); });
}

#endif // INTRINSIC_ATTEMPTS_H
