// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_CONTOURS_TO_CUT_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_CONTOURS_TO_CUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/internal/curves/Contour_choice.h>
#include <CGAL/Reeb_graph/internal/curves/Contour_cutting.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether each two halfedges that follow each other are edges of one face, on the right of the first one.
template <class RankedMesh, class HalfedgeDescriptor>
bool is_connected(const RankedMesh& ranked, const std::vector<HalfedgeDescriptor>& halfedges, bool is_closed)
{
  const auto& mesh = ranked.mesh();
  const std::size_t size = halfedges.size();
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < size; ++i)
  {
    const HalfedgeDescriptor h = opposite(halfedges[i], mesh), following = halfedges[(i + 1) % size];
    if(is_border(h, mesh) || (next(h, mesh) != following && prev(h, mesh) != following))
      return false;
  }
  return is_closed || (is_border(halfedges.front(), mesh) && is_border(opposite(halfedges.back(), mesh), mesh));
}

// Checks that the halfedges of each contour ascend, follow each other, and cross a common level.
template <class RankedMesh, class ContourRange>
auto make_contours_to_cut(const RankedMesh& ranked, const ContourRange& contours)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  const auto& mesh = ranked.mesh();
  std::vector<Contour_to_cut<halfedge_descriptor>> result;
  for(const auto& contour : contours)
  {
    if(contour.halfedges.empty() || !is_connected(ranked, contour.halfedges, contour.is_closed))
      throw Invalid_contour_error(result.size());
    result.push_back(make_contour_to_cut(ranked, contour.halfedges, contour.is_closed));
    for(const halfedge_descriptor h : contour.halfedges)
    {
      if(ranked.rank(target(h, mesh)) <= result.back().lower_rank)
        throw Invalid_contour_error(result.size() - 1);
    }
    result.back().value = contour.value;
  }
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_CONTOURS_TO_CUT_H
