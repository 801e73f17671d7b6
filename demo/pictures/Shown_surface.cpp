// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Shown_surface.h"

#include <algorithm>
#include <unordered_set>

std::vector<std::int64_t> parts_of(const std::vector<std::int64_t>& values, const std::string& name,
                                   const Output_mesh& mesh)
{
  const Attribute& owners = *find_attribute(mesh.polygon_data, name);
  const std::unordered_set<std::int64_t> wanted(values.begin(), values.end());
  std::vector<std::int64_t> result;
  for(std::size_t i = 0; i < owners.size(); ++i)
    if(wanted.count(owners.integer(i)) > 0)
      result.push_back(std::int64_t(i));
  return result;
}

const Attribute* find_attribute(const std::vector<Attribute>& data, const std::string& name)
{
  const auto found =
    std::find_if(data.begin(), data.end(), [&](const Attribute& a) { return a.name == name; });
  return found == data.end() ? nullptr : &*found;
}
