// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_COMPONENT_LOOPS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_COMPONENT_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/Integer_rows.h>
#include <CGAL/Reeb_graph/handles/internal/Linking_numbers.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The loops of one component: coordinates of closed walks in the basis b of its tree, and intersection numbers.
class Component_loops
{
public:
  // `pieces_of_vertices` and `pieces_of_faces` are places for numbers, no_index for this component.
  Component_loops(const Closed_surface& surface,
                  const Tree_and_cotree& trees,
                  const Tree_and_cotree::Component& component,
                  std::vector<Index>& pieces_of_vertices,
                  std::vector<Index>& pieces_of_faces)
    : surface_(surface),
      trees_(trees),
      component_(component),
      pieces_(vertices_of_ends(), pieces_of_vertices, [&](Index v) { return trees.parent(v); }),
      copieces_(faces_of_ends(), pieces_of_faces, [&](Index f) { return trees.parent_face(f); })
  {
    for(std::size_t k = 0; k != size(); ++k)
      numbers_.emplace(component.left_over[k], k);
  }

  std::size_t size() const { return component_.left_over.size(); } // twice the genus
  const Tree_and_cotree::Component& component() const { return component_; }
  Halfedge_walk walk(std::size_t k) const { return trees_.walk_through(component_.left_over[k]); }

  Integer_rows linking_numbers() const { return Linking_numbers(surface_, trees_, component_, pieces_, copieces_)(); }

  // The coordinates of a closed walk in the basis b: how often each loop c crosses it from its right to its left.
  std::vector<long long> coordinates(const Halfedge_walk& walk) const
  {
    std::vector<long long> result(size(), 0), sums(copieces_.size(), 0);
    for(const Index h : walk)
    {
      const auto number = numbers_.find(h & ~Index(1));
      if(number != numbers_.end())
        result[number->second] += h == component_.left_over[number->second] ? 1 : -1;
      for(const Index g : {h, surface_.opposite(h)})
      {
        // A loop c that leads to the parent of the face on the left of a halfedge crosses it from its left.
        const Index face = surface_.face[g];
        if(trees_.to_parent(face) == g && copieces_.piece_of(face) != no_index)
          sums[copieces_.piece_of(face)] -= g == h ? 1 : -1;
      }
    }
    for(Index piece = 0; piece != copieces_.size(); ++piece)
    {
      if(copieces_.parent(piece) != no_index)
        sums[piece] += sums[copieces_.parent(piece)];
    }
    const auto sum_at = [&](Index face) {
      return copieces_.piece_of(face) == no_index ? 0 : sums[copieces_.piece_of(face)];
    };
    for(std::size_t k = 0; k != size(); ++k)
    {
      const Index h = component_.left_over[k];
      result[k] += sum_at(surface_.face[h]) - sum_at(surface_.face[surface_.opposite(h)]);
    }
    return result;
  }

  // The intersection numbers of the loops b with each other, and of the loops c with each other. The second matrix
  // has the coordinates of the loops c in the basis b, and its transpose is the inverse of the first one.
  std::array<Integer_rows, 2> intersection_numbers() const
  {
    const std::vector<Index> ends = ends_around_tree();
    std::unordered_map<Index, std::size_t> places;
    for(std::size_t i = 0; i != ends.size(); ++i)
      places.emplace(ends[i], i);
    // The border of the polygon that is left if the surface is cut along the loops b, as it is passed counterclockwise.
    std::vector<Index> sides;
    for(std::size_t place = 0; sides.size() != ends.size();)
    {
      sides.push_back(ends[place]);
      place = (places[surface_.opposite(ends[place])] + ends.size() - 1) % ends.size();
    }
    return {crossings(ends), crossings(sides)};
  }

private:
  std::vector<Index> vertices_of_ends() const
  {
    std::vector<Index> result;
    for(const Index h : component_.left_over)
    {
      result.push_back(surface_.source(h));
      result.push_back(surface_.target[h]);
    }
    return result;
  }
  std::vector<Index> faces_of_ends() const
  {
    std::vector<Index> result;
    for(const Index h : component_.left_over)
    {
      result.push_back(surface_.face[h]);
      result.push_back(surface_.face[surface_.opposite(h)]);
    }
    return result;
  }

  bool is_in_pieces(Index h) const
  {
    const Index v = surface_.target[h], u = surface_.source(h);
    return (trees_.to_vertex(v) == h && pieces_.piece_of(v) != no_index)
        || (trees_.to_vertex(u) == surface_.opposite(h) && pieces_.piece_of(u) != no_index);
  }

  // The halfedges that leave the tree along an edge that is left over, as they lie around it, counterclockwise.
  std::vector<Index> ends_around_tree() const
  {
    std::vector<Index> result;
    const Index first = surface_.outgoing[component_.root];
    Index h = first;
    do
    {
      if(numbers_.count(h & ~Index(1)) != 0)
        result.push_back(h);
      h = surface_.turned(is_in_pieces(h) ? surface_.opposite(h) : h);
    } while(h != first);
    return result;
  }

  // The intersection numbers of chords of a circle: chord k leads from the place of left_over[k] to that of its
  // opposite, and around the tree, the other way round on the outside. Counterclockwise, they begin, begin, end, end if
  // the second one crosses the first one from its right to its left.
  Integer_rows crossings(const std::vector<Index>& places) const
  {
    std::vector<std::array<std::size_t, 2>> chords(size());
    for(std::size_t i = 0; i != places.size(); ++i)
    {
      const std::size_t k = numbers_.at(places[i] & ~Index(1));
      chords[k][places[i] == component_.left_over[k] ? 0 : 1] = i;
    }
    Integer_rows result(size(), std::vector<long long>(size(), 0));
    for(std::size_t i = 0; i != size(); ++i)
      for(std::size_t j = 0; j != size(); ++j)
      {
        if(i == j)
          continue;
        const auto after_begin = [&](std::size_t place) {
          return (place + places.size() - chords[i][0]) % places.size();
        };
        const bool begins_right = after_begin(chords[j][0]) < after_begin(chords[i][1]);
        const bool ends_right = after_begin(chords[j][1]) < after_begin(chords[i][1]);
        result[i][j] = begins_right == ends_right ? 0 : begins_right ? 1 : -1;
      }
    return result;
  }

  const Closed_surface& surface_;
  const Tree_and_cotree& trees_;
  const Tree_and_cotree::Component& component_;
  Forest_pieces pieces_, copieces_;
  std::unordered_map<Index, std::size_t> numbers_; // of the even halfedges that are left over
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_COMPONENT_LOOPS_H
