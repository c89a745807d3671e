// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef REEB_GRAPH_TEST_RANKS_H
#define REEB_GRAPH_TEST_RANKS_H

#include "random_meshes.h"

#include <CGAL/Reeb_graph/distributed/compute_reeb_graph_distributed.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/range/irange.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

// Surfaces that all ranks know, and the part that each of them brings.
namespace ranks {
using random_meshes::Combinatorial_mesh;
using random_meshes::Random;

typedef std::array<std::uint64_t, 3> Triangle;

inline const boost::mpi::communicator& world()
{
  static const boost::mpi::communicator communicator;
  return communicator;
}
inline std::size_t rank() { return static_cast<std::size_t>(world().rank()); }
inline std::size_t number_of_ranks() { return static_cast<std::size_t>(world().size()); }

template <class Scalar>
struct Surface
{
  Combinatorial_mesh mesh;
  std::vector<Scalar> values;
};

template <class Scalar>
struct Local_input
{
  boost::integer_range<std::uint64_t> vertices = boost::irange<std::uint64_t>(0, 0);
  std::vector<Triangle> triangles;
  std::vector<Scalar> scalars;

  void bring_vertices(const Surface<Scalar>& surface, std::size_t begin, std::size_t end)
  {
    vertices = boost::irange<std::uint64_t>(begin, end);
    scalars.assign(surface.values.begin() + static_cast<std::ptrdiff_t>(begin),
                   surface.values.begin() + static_cast<std::ptrdiff_t>(end));
  }
};

// Where an equal part of each rank begins, if they are in order.
inline std::size_t begin_of_rank(std::size_t size, std::size_t rank) { return rank * size / number_of_ranks(); }

// Equal parts, in the order of the ranks.
template <class Scalar>
Local_input<Scalar> part_in_order(const Surface<Scalar>& surface)
{
  Local_input<Scalar> input;
  const std::size_t size = surface.mesh.triangles.size(), vertices = surface.mesh.number_of_vertices;
  for(std::size_t i = begin_of_rank(size, rank()); i < begin_of_rank(size, rank() + 1); ++i)
    input.triangles.push_back(
      {surface.mesh.triangles[i][0], surface.mesh.triangles[i][1], surface.mesh.triangles[i][2]});
  input.bring_vertices(surface, begin_of_rank(vertices, rank()), begin_of_rank(vertices, rank() + 1));
  return input;
}

// Random ranges of vertices, some of them empty, in random order, and random triangles, of which some ranks may have
// none.
template <class Scalar>
Local_input<Scalar> random_part(const Surface<Scalar>& surface, Random& random)
{
  std::vector<std::size_t> cuts = {0, surface.mesh.number_of_vertices}, places(number_of_ranks());
  while(cuts.size() <= number_of_ranks())
    cuts.push_back(random.below(4) == 0 ? cuts[random.below(cuts.size())]
                                        : random.below(surface.mesh.number_of_vertices + 1));
  std::sort(cuts.begin(), cuts.end());
  std::iota(places.begin(), places.end(), std::size_t(0));
  random.shuffle(places);
  Local_input<Scalar> input;
  input.bring_vertices(surface, cuts[places[rank()]], cuts[places[rank()] + 1]);

  const std::size_t ranks_with_triangles =
    random.below(2) == 0 ? number_of_ranks() : 1 + random.below(number_of_ranks());
  for(const auto& t : surface.mesh.triangles)
    if(places[random.below(ranks_with_triangles)] == rank())
      input.triangles.push_back({t[0], t[1], t[2]});
  return input;
}

template <class Scalar>
using Graph = typename CGAL::Reeb_graph_soup_traits<Scalar>::Graph;

template <class Scalar, class NamedParameters>
Graph<Scalar> graph_on_ranks(const Local_input<Scalar>& input, const NamedParameters& np)
{
  Graph<Scalar> graph;
  add_vertex(graph);
  CGAL::compute_reeb_graph_distributed(world(), input.vertices, input.triangles, input.scalars, graph, np);
  return graph;
}

template <class Scalar, class NamedParameters>
Graph<Scalar> graph_of_whole(const Surface<Scalar>& surface, const NamedParameters& np)
{
  Graph<Scalar> graph;
  CGAL::compute_reeb_graph_of_soup(surface.mesh.number_of_vertices, surface.mesh.triangles, surface.values, graph, np);
  return graph;
}

} // namespace ranks

#endif // REEB_GRAPH_TEST_RANKS_H
