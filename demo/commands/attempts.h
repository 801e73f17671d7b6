// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ATTEMPTS_H
#define INTRINSIC_ATTEMPTS_H

#include "commands/Command_run.h"

#include <functional>

// Returns the result of `compute()`, an exit code. If rounding makes it impossible because of
// almost flat triangles, it is computed again with longer edges. If this fails, too, the error of
// the unchanged surface is thrown. A map that fails is not computed again, because it would be the
// map of another surface.
int attempt(Command_run& run, const std::function<int()>& compute);

// Returns the result of a command that is a class.
template <class Command, class Own_options>
int attempted(const Common_options& common, const Own_options& options)
{
  Command command(common, options);
  return attempt(command.command_run(), [&] { return command.run(); });
}

#endif // INTRINSIC_ATTEMPTS_H
