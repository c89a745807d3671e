// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SUM_COUNTS_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SUM_COUNTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Critical_vertex_counts.h>
#include <CGAL/Reeb_graph/internal/distributed/exchange.h>
#include <CGAL/Reeb_graph/internal/distributed/pass_arrays.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The sum of the counts of all ranks. Collective.
inline Critical_vertex_counts sum_counts(Exchange& exchange, const Critical_vertex_counts& own)
{
  typedef std::array<std::uint64_t, 2> Saddles; // their multiplicity, and how many they are
  std::vector<Saddles> saddles;
  exchange.in_agreement([&] { saddles.assign(own.saddles.size(), {}); });
  auto place = saddles.begin();
  for(const auto& [multiplicity, number] : own.saddles)
    *place++ = {multiplicity, number};
  std::vector<Saddles> all_saddles = gather_arrays(exchange, saddles).elements;
  exchange.broadcast(all_saddles);

  Critical_vertex_counts sum;
  exchange.in_agreement([&] {
    for(const auto& [multiplicity, number] : all_saddles)
      sum.saddles[static_cast<std::size_t>(multiplicity)] += static_cast<std::size_t>(number);
  });
  for(const auto& of_rank :
      exchange.all_gather(std::array<std::size_t, 4>{own.isolated, own.minima, own.maxima, own.border_saddles}))
  {
    sum.isolated += of_rank[0];
    sum.minima += of_rank[1];
    sum.maxima += of_rank[2];
    sum.border_saddles += of_rank[3];
  }
  return sum;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SUM_COUNTS_H
