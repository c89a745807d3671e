// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LIMITS_OF_KINDS_H
#define CGAL_REEB_GRAPH_SRC_LIMITS_OF_KINDS_H

#include "input/field_input.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace reeb_graph_program {
// What is not for each kind of mesh: a command, an option, or a field, and whether it takes triangles that are no oriented
// manifold surface, tetrahedra, and both together. The manual has the same table.
struct Limit
{
  std::string_view what;
  bool takes_triangles, takes_tetrahedra, takes_both;
  std::string_view why; // if it is not that it needs a surface
};

constexpr std::string_view no_surface = "the mesh is not an oriented manifold surface";

constexpr std::array<Limit, 11> limits = {{
  {"curves", false, false, false, no_surface},
  {"handles", false, false, false, no_surface},
  {"skeleton", false, false, false, no_surface},
  {"--html", false, false, false, ""},
  {"--simplified-scalars", false, false, false, ""},
  {"the field harmonic", false, false, false, ""},
  {"the field harmonic-between-borders", false, false, false, ""},
  {"the field poisson", false, false, false, ""},
  {"the field unit-gradient", false, false, false, ""},
  {"--mesh-out", true, false, false,
   "--mesh-out writes triangles, and the mesh has tetrahedra: --vertex-arcs writes where each vertex belongs"},
  {"contour", true, true, false,
   "there are triangles that are faces of no tetrahedron: contours of such a mesh are neither polylines nor triangles"},
}};

// Why that is not for the mesh; nothing if it is.
inline std::string reason_against(std::string_view what, const Mesh& mesh)
{
  const auto limit = std::find_if(limits.begin(), limits.end(), [&](const Limit& l) { return l.what == what; });
  if(!mesh.complex || limit == limits.end()
     || (mesh.complex->has_triangles_and_tetrahedra() ? limit->takes_both
         : mesh.complex->tetrahedra.empty()           ? limit->takes_triangles
                                                      : limit->takes_tetrahedra))
    return "";
  if(!limit->why.empty() && limit->why != no_surface)
    return std::string(limit->why);
  return (limit->why.empty() ? std::string(what) + " needs an oriented manifold surface" : std::string(limit->why))
       + "; " + describe_obstacle(mesh);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LIMITS_OF_KINDS_H
