// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEFINE_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEFINE_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Named_function_parameters.h>

// A list of parameters is a macro that applies its argument to each name. The tag of a parameter is
// `internal_np::name_t`, which is CGAL's own where CGAL has one.

#define CGAL_NAMED_PARAMETER_TAG(name) enum name##_t{name};

#define CGAL_NAMED_PARAMETER_FUNCTION(name)                                                        \
  template <typename T>                                                                            \
  auto name(const T& value)                                                                        \
  {                                                                                                \
    return internal_np::Named_parameters<T, internal_np::name##_t>(value);                         \
  }

#define CGAL_NAMED_PARAMETER_MEMBER(name)                                                          \
  template <typename K>                                                                            \
  auto name(const K& value) const                                                                  \
  {                                                                                                \
    return Named_parameters<K, internal_np::name##_t, Named_parameters>(value, *this);             \
  }

// Defines, in the namespace of a package, the functions of `parameters` that begin a sequence of
// named parameters, and the class of sequences, whose member functions append. It is derived from
// CGAL's class, which get_parameter() therefore deduces; of repeated parameters, the last counts.
#define CGAL_DEFINE_NAMED_PARAMETERS(list)                                                         \
  namespace internal_np {                                                                          \
  template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>              \
  struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>                          \
  {                                                                                                \
    using CGAL::Named_function_parameters<T, Tag, Base>::Named_function_parameters;                \
    list(CGAL_NAMED_PARAMETER_MEMBER)                                                              \
  };                                                                                               \
  }                                                                                                \
  namespace parameters {                                                                           \
  list(CGAL_NAMED_PARAMETER_FUNCTION)                                                              \
  }

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEFINE_NAMED_PARAMETERS_H
