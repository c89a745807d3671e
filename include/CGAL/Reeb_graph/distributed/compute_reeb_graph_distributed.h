// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/Distributed_slab.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgReebGraphRef
///
/// \brief computes the augmented Reeb graph of a scalar field on a surface that is spread over the ranks of a
/// communicator.
///
/// All ranks call this together. Rank 0 gets the graph, the other ones an empty one.
///
/// \param communicator the ranks
/// \param local_vertices the global indices of the vertices of this rank, a contiguous range
/// \param local_triangles triangles, by the global indices of their vertices
/// \param local_scalars the values of `local_vertices`
/// \param graph the result
/// \param np named parameters
template <class VertexRange,
          class TriangleRange,
          class ScalarRange,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
void compute_reeb_graph_distributed(const boost::mpi::communicator& communicator,
                                    const VertexRange& local_vertices,
                                    const TriangleRange& local_triangles,
                                    const ScalarRange& local_scalars,
                                    ReebGraph& graph,
                                    const NamedParameters& np = parameters::default_values())
{
  // A stand-in, which gathers all at rank 0.
  typedef std::decay_t<decltype(*std::begin(local_scalars))> Scalar;
  std::vector<std::array<std::uint64_t, 3>> triangles;
  for(const auto& t : local_triangles)
    triangles.push_back(
      {static_cast<std::uint64_t>(t[0]), static_cast<std::uint64_t>(t[1]), static_cast<std::uint64_t>(t[2])});
  const std::vector<Scalar> scalars(std::begin(local_scalars), std::end(local_scalars));
  const std::uint64_t first = local_vertices.empty() ? 0 : *std::begin(local_vertices);
  std::vector<std::vector<std::array<std::uint64_t, 3>>> all_triangles;
  std::vector<std::vector<Scalar>> all_scalars;
  std::vector<std::uint64_t> all_first;
  boost::mpi::gather(communicator, triangles, all_triangles, 0);
  boost::mpi::gather(communicator, scalars, all_scalars, 0);
  boost::mpi::gather(communicator, first, all_first, 0);
  graph = ReebGraph();
  if(communicator.rank() == 0)
  {
    std::size_t number_of_vertices = 0;
    for(const auto& part : all_scalars)
      number_of_vertices += part.size();
    std::vector<Scalar> field(number_of_vertices);
    triangles.clear();
    for(std::size_t rank = 0; rank < all_scalars.size(); ++rank)
    {
      for(std::size_t i = 0; i < all_scalars[rank].size(); ++i)
        field.at(all_first[rank] + i) = all_scalars[rank][i];
      triangles.insert(triangles.end(), all_triangles[rank].begin(), all_triangles[rank].end());
    }
    compute_reeb_graph_of_soup(number_of_vertices, triangles, field, graph, np);
  }
  communicator.barrier();
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_COMPUTE_REEB_GRAPH_DISTRIBUTED_H
