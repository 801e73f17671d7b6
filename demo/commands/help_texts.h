// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_HELP_TEXTS_H
#define INTRINSIC_HELP_TEXTS_H

// What the help of the program and of its commands says after the options.
namespace Help {

extern const char* const examples;
extern const char* const view;
extern const char* const refine;
extern const char* const distance;
extern const char* const path;
extern const char* const transfer;
extern const char* const operators;
extern const char* const flatten;
extern const char* const hyperbolic;
extern const char* const uniformize;
extern const char* const sphere;
extern const char* const simplify;

} // namespace Help

#endif // INTRINSIC_HELP_TEXTS_H
