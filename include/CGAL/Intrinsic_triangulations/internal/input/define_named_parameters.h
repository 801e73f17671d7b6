// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Defines the named parameters of a package, in its namespace. This file is included once for each
// package, after `CGAL_NAMED_PARAMETERS` has been defined as the header that lists them. It has no
// include guard, and undefines the macro. A list applies `CGAL_named_parameter` to each name, and
// to names of other packages unless `CGAL_DEFINING_TAGS` is defined.
//
// The tag of a parameter is `internal_np::name_t`, which is CGAL's own if CGAL has one. The
// functions in `parameters` begin a sequence of named parameters. The member functions of the class
// of sequences append; it is derived from CGAL's class, which get_parameter() therefore deduces. Of
// repeated parameters, the last counts.

#ifdef CGAL_NAMED_PARAMETERS

namespace internal_np {

#define CGAL_DEFINING_TAGS
#define CGAL_named_parameter(name) enum name##_t{name};
#include CGAL_NAMED_PARAMETERS
#undef CGAL_named_parameter
#undef CGAL_DEFINING_TAGS

template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using CGAL::Named_function_parameters<T, Tag, Base>::Named_function_parameters;

#define CGAL_named_parameter(name)                                                                 \
  template <typename K>                                                                            \
  auto name(const K& value) const                                                                  \
  {                                                                                                \
    return Named_parameters<K, internal_np::name##_t, Named_parameters>(value, *this);             \
  }
#include CGAL_NAMED_PARAMETERS
#undef CGAL_named_parameter
};

} // namespace internal_np

namespace parameters {

#define CGAL_named_parameter(name)                                                                 \
  template <typename T>                                                                            \
  auto name(const T& value)                                                                        \
  {                                                                                                \
    return internal_np::Named_parameters<T, internal_np::name##_t>(value);                         \
  }
#include CGAL_NAMED_PARAMETERS
#undef CGAL_named_parameter

} // namespace parameters

#undef CGAL_NAMED_PARAMETERS

#endif
