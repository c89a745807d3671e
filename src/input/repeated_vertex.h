// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPEATED_VERTEX_H
#define CGAL_REEB_GRAPH_SRC_REPEATED_VERTEX_H

#include "input/Polygon_soup.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// The first vertex at two corners, none if there is none. `sorted` is room that calls share.
inline std::optional<Corner> find_repeated_vertex(Polygons::Polygon polygon, std::vector<Corner>& sorted)
{
  if(polygon.size() == 3)
  {
    const Corner* const v = polygon.begin();
    return v[0] == v[1] || v[0] == v[2] ? std::make_optional(v[0])
         : v[1] == v[2]                 ? std::make_optional(v[1])
                                        : std::nullopt;
  }
  sorted.assign(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  return repeated == sorted.end() ? std::nullopt : std::make_optional(*repeated);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPEATED_VERTEX_H
