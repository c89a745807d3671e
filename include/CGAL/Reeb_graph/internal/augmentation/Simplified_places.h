// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SIMPLIFIED_PLACES_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SIMPLIFIED_PLACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The places in a simplified graph of the nodes, and behind them the arcs, of the exact graph. In a graph that has not
// been simplified, each has the same place.
class Simplified_places
{
public:
  // From a Simplification, or from no named parameter.
  template <class Parameter>
  explicit Simplified_places(const Parameter& simplification)
  {
    if constexpr(is_given<Parameter>)
    {
      is_simplified_ = true;
      for(std::size_t node = 0; node != simplification.number_of_old_nodes(); ++node)
        places_.push_back(static_cast<Index>(simplification.index_of_node(node)));
      for(std::size_t arc = 0; arc != simplification.number_of_old_arcs(); ++arc)
        places_.push_back(static_cast<Index>(simplification.index_of_arc(arc)));
    }
    else
      static_cast<void>(simplification);
  }

  bool is_simplified() const { return is_simplified_; }
  std::size_t size() const { return places_.size(); }
  Index operator()(Index place) const { return is_simplified_ ? places_[place] : place; }

private:
  bool is_simplified_ = false;
  std::vector<Index> places_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_SIMPLIFIED_PLACES_H
