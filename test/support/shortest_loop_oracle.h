// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_SHORTEST_LOOP_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_SHORTEST_LOOP_ORACLE_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// How short loops of a homology class can be, by all paths of the cover of the surface where only loops close that have
// no class.
namespace shortest_loop_oracle {

// The halfedges that a closed walk crosses once it is pushed a little to its left, and how often from right to left.
template <class Mesh, class Walk>
auto crossings_on_the_left(const Mesh& mesh, const Walk& walk)
{
  std::map<typename boost::graph_traits<Mesh>::halfedge_descriptor, int> crossings;
  for(std::size_t k = 0; k != walk.size(); ++k)
  {
    const auto back = opposite(walk[(k + walk.size() - 1) % walk.size()], mesh);
    for(auto h = opposite(prev(walk[k], mesh), mesh); h != back; h = opposite(prev(h, mesh), mesh))
    {
      ++crossings[h];
      --crossings[opposite(h, mesh)];
    }
  }
  return crossings;
}

template <class Mesh>
class Shortest_loops
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef std::vector<int> Class; // how often each loop of a basis is crossed
  typedef std::pair<vertex_descriptor, Class> Place;

public:
  template <class Loops>
  Shortest_loops(const Mesh& mesh, const Loops& basis) : mesh_(mesh)
  {
    for(const auto h : halfedges(mesh))
    {
      classes_[h].assign(basis.size(), 0);
      const auto &p = get(points_of(mesh), source(h, mesh)), &q = get(points_of(mesh), target(h, mesh));
      lengths_[h] = std::sqrt(CGAL::squared_distance(p, q));
    }
    for(std::size_t i = 0; i != basis.size(); ++i)
      for(const auto& [h, number] : crossings_on_the_left(mesh, basis[i].halfedges))
        classes_[h][i] = number;
  }

  // The least length in the class of a walk among loops through vertices of another one that are shorter than `bound`,
  // or that. Half of such a loop leads from the vertex to its middle edge, and the other half back to it.
  template <class Walk>
  double operator()(const Walk& walk, const Walk& other, double bound) const
  {
    Class wanted = classes_.begin()->second;
    std::fill(wanted.begin(), wanted.end(), 0);
    const Class none = wanted;
    for(const auto h : walk)
      wanted = moved(wanted, classes_.at(h), 1);
    double least = bound;
    for(const auto h : other)
    {
      const auto distances = distances_from({source(h, mesh_), none}, least / 2);
      for(const auto& [place, distance] : distances)
        for(const auto g : CGAL::halfedges_around_source(place.first, mesh_))
        {
          const auto end =
            distances.find({target(g, mesh_), moved(moved(place.second, classes_.at(g), 1), wanted, -1)});
          if(end != distances.end())
            least = (std::min)(least, distance + lengths_.at(g) + end->second);
        }
    }
    return least;
  }

private:
  static auto points_of(const Mesh& mesh) { return get(CGAL::vertex_point, mesh); }

  static Class moved(Class a, const Class& b, int sign)
  {
    for(std::size_t i = 0; i != a.size(); ++i)
      a[i] += sign * b[i];
    return a;
  }

  // Those of the places that are not farther than `bound`.
  std::map<Place, double> distances_from(const Place& root, double bound) const
  {
    std::map<Place, double> distances, settled;
    std::set<std::pair<double, Place>> queue = {{0, root}};
    distances[root] = 0;
    while(!queue.empty())
    {
      const auto [distance, place] = *queue.begin();
      queue.erase(queue.begin());
      settled.emplace(place, distance);
      for(const auto h : CGAL::halfedges_around_source(place.first, mesh_))
      {
        const double longer = distance + lengths_.at(h);
        if(longer > bound)
          continue;
        const Place next = {target(h, mesh_), moved(place.second, classes_.at(h), 1)};
        const auto [known, is_new] = distances.emplace(next, longer);
        if(!is_new && known->second <= longer)
          continue;
        queue.erase({known->second, next});
        known->second = longer;
        queue.emplace(longer, next);
      }
    }
    return settled;
  }

  const Mesh& mesh_;
  std::map<halfedge_descriptor, Class> classes_;
  std::map<halfedge_descriptor, double> lengths_;
};

} // namespace shortest_loop_oracle

#endif // CGAL_REEB_GRAPH_TEST_SHORTEST_LOOP_ORACLE_H
