// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VERTEX_PROPERTIES_H
#define CGAL_REEB_GRAPH_SRC_VERTEX_PROPERTIES_H

#include "base/surface.h"

#include <CGAL/version.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

namespace reeb_graph_program {
template <class Number>
std::optional<Vertex_property<Number>> find_vertex_property(const Surface& surface, const std::string& name)
{
  const auto found = surface.property_map<Surface::Vertex_index, Number>(name);
#if CGAL_VERSION_NR >= 1060000000
  return found;
#else
  return found.second ? std::make_optional(found.first) : std::nullopt;
#endif
}

template <class Visit, class... Number>
void visit_vertex_property(const Surface& surface,
                           const std::string& name,
                           const Visit& visit,
                           const std::variant<Vertex_property<Number>...>*)
{
  const auto visit_if_found = [&](const auto& map) {
    if(map)
      visit(name.substr(2), *map);
  };
  (visit_if_found(find_vertex_property<Number>(surface, name)), ...);
}

// The given vertices of which each one is a copy, or between which it is, if a repair has added some: the given ones come
// first, and are their own.
typedef Vertex_property<std::array<std::uint32_t, 2>> Origin_map;
constexpr const char* name_of_origins = "origins";

inline std::size_t number_of_given_vertices(const Surface& surface)
{
  const auto origins = find_vertex_property<std::array<std::uint32_t, 2>>(surface, name_of_origins);
  std::size_t number = 0;
  for(const Surface::Vertex_index v : surface.vertices())
    number += !origins || (*origins)[v][0] == v ? 1 : 0;
  return number;
}

// Gives those that have been added the numbers of what they are copies of, or a mean.
template <class Map>
void set_added_vertices(const Surface& surface, Map map)
{
  typedef typename Map::value_type Number;
  if(const auto origins = find_vertex_property<std::array<std::uint32_t, 2>>(surface, name_of_origins))
    for(const Surface::Vertex_index v : surface.vertices())
    {
      const auto [a, b] = (*origins)[v];
      map[v] = map[Surface::Vertex_index(a)];
      if(std::is_floating_point_v<Number> && a != b)
        map[v] = static_cast<Number>(map[v] / 2 + map[Surface::Vertex_index(b)] / 2);
    }
}

// Calls visit(name, map) for the properties of numbers that a surface has: those that files have besides the points, whose
// names begin with v: in the surface.
template <class Visit>
void visit_vertex_properties(const Surface& surface, const Visit& visit)
{
  for(const std::string& name : surface.properties<Surface::Vertex_index>())
    if(name.compare(0, 2, "v:") == 0)
      visit_vertex_property(surface, name, visit, static_cast<const Any_vertex_property*>(nullptr));
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VERTEX_PROPERTIES_H
