// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CRITICAL_VERTEX_COUNTS_H
#define CGAL_REEB_GRAPH_CRITICAL_VERTEX_COUNTS_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <map>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphRef
///
/// \brief the number of critical vertices of each kind: a property of the field, not of its Reeb graph.
///
/// With \f$ m \f$ the multiplicity, the number of lower link sectors minus one, a closed surface has Euler
/// characteristic \f$ minima - \sum m + maxima \f$.
struct Critical_vertex_counts
{
  std::size_t isolated = 0; ///< vertices without a face
  std::size_t minima = 0;   ///< vertices whose link is all above, border vertices included
  std::size_t maxima = 0;   ///< vertices whose link is all below, border vertices included
  /// interior vertices with at least two lower link sectors, by multiplicity
  std::map<std::size_t, std::size_t> saddles;
  std::size_t border_saddles = 0; ///< border vertices with at least two lower or two upper link sectors
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CRITICAL_VERTEX_COUNTS_H
