// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PIECE_SWEEP_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PIECE_SWEEP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/Triangle_neighbors.h>
#include <CGAL/Reeb_graph/internal/simplification/Vertex_ring.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A level that rises over some vertices of a surface, the members, while all other vertices stay where they are: one
// vertex after another passes from above it to below it, and back. It tells by which steps the Reeb graph of the part
// that has been swept gets no loop and no leaf: a vertex has to have contours below and above it, and those below must
// belong to parts that nothing has joined yet. `IsLower` tells where the other vertices are.
template <class IsLower>
class Piece_sweep
{
public:
  typedef scalar_fields::Position Position;

  enum class Step
  {
    IMPOSSIBLE, // there would be a leaf or a loop
    REGULAR,    // one sector of the link below, and one above
    PASSING,    // one contour below, and one above: no node
    BRANCHING   // a node
  };

  Piece_sweep(const scalar_fields::Weighted_graph& graph,
              const Triangle_neighbors& triangles,
              const std::vector<Position>& members,
              const IsLower& is_lower)
    : graph_(graph),
      triangles_(triangles),
      is_lower_(is_lower),
      members_(members.begin(), members.end()),
      is_swept_(members.size(), false),
      parents_(members.size()),
      sizes_(members.size(), 1)
  {
    for(const Member_index m : members_.keys())
    {
      numbers_.emplace(members_[m], m);
      parents_[m] = m;
    }
  }

  const Indexed_vector<Member_index, Position>& members() const { return members_; }
  const std::vector<Member_index>& swept() const { return swept_; }
  bool is_swept(Member_index m) const { return is_swept_[m]; }

  // What adding a member would be.
  Step step(Member_index m)
  {
    const Position v = members_[m];
    Vertex_contours lower = make_ring(v, Side::LOWER).contours(), upper = make_ring(v, Side::UPPER).contours();
    if(lower.number == 0 || upper.number == 0)
      return Step::IMPOSSIBLE;
    if(lower.number == 1 && upper.number == 1)
      return Step::REGULAR;
    if(lower.number > 1)
      lower = trace_contours(v, Side::LOWER);
    std::vector<Member_index> parts;
    for(const Member_index label : lower.labels)
    {
      if(label != no_index)
        parts.push_back(part_of(label));
    }
    std::sort(parts.begin(), parts.end());
    if(std::adjacent_find(parts.begin(), parts.end()) != parts.end())
      return Step::IMPOSSIBLE;
    if(lower.number == 1 && upper.number > 1)
      upper = trace_contours(v, Side::UPPER);
    return lower.number == 1 && upper.number == 1 ? Step::PASSING : Step::BRANCHING;
  }

  // Lets a member for which there is a step pass.
  void add(Member_index m)
  {
    joined_.push_back(no_index);
    for(const Member_index label : trace_contours(members_[m], Side::LOWER).labels)
    {
      if(label != no_index)
        join(part_of(label), part_of(m));
    }
    is_swept_[m] = true;
    swept_.push_back(m);
  }

  // Takes the last step back.
  void remove_last()
  {
    for(; joined_.back() != no_index; joined_.pop_back())
    {
      const Member_index part = joined_.back();
      sizes_[parents_[part]] -= sizes_[part];
      parents_[part] = part;
    }
    joined_.pop_back();
    is_swept_[swept_.back()] = false;
    swept_.pop_back();
  }

  // Calls visit(member) for the members around one.
  template <class Visit>
  void for_each_neighbor(Member_index m, const Visit& visit) const
  {
    for(const auto& neighbor : graph_.neighbors(members_[m]))
    {
      const auto it = numbers_.find(neighbor.vertex);
      if(it != numbers_.end())
        visit(it->second);
    }
  }

  bool has_lower_neighbor(Member_index m) const
  {
    const auto neighbors = graph_.neighbors(members_[m]);
    return std::any_of(neighbors.begin(), neighbors.end(), [&](const auto& n) { return is_below(n.vertex); });
  }

  // Whether some members could pass no more, as those that are left around them are below.
  bool has_pocket() const
  {
    Indexed_vector<Member_index, bool> is_reached(members_.size(), false);
    std::vector<Member_index> stack;
    const auto reach = [&](Member_index m) {
      if(is_swept_[m] || is_reached[m])
        return;
      is_reached[m] = true;
      stack.push_back(m);
    };
    for(const Member_index m : members_.keys())
    {
      for(const auto& neighbor : graph_.neighbors(members_[m]))
      {
        if(numbers_.count(neighbor.vertex) == 0 && !is_lower_(neighbor.vertex))
        {
          reach(m);
          break;
        }
      }
    }
    std::size_t number_of_reached = 0;
    for(; !stack.empty(); ++number_of_reached)
    {
      const Member_index m = stack.back();
      stack.pop_back();
      for_each_neighbor(m, reach);
    }
    return number_of_reached + swept_.size() != members_.size();
  }

private:
  bool is_below(Position v) const
  {
    const auto it = numbers_.find(v);
    return it == numbers_.end() ? is_lower_(v) : bool(is_swept_[it->second]);
  }

  bool is_on(Position v, Side side) const { return is_below(v) == (side == Side::LOWER); }

  // The part that a swept member belongs to: those that the surface below the level connects.
  Member_index part_of(Member_index m) const
  {
    while(parents_[m] != m)
      m = parents_[m];
    return m;
  }

  void join(Member_index a, Member_index b)
  {
    const auto [part, root] = std::minmax(a, b, [&](Member_index i, Member_index j) { return sizes_[i] < sizes_[j]; });
    sizes_[root] += sizes_[part];
    parents_[part] = root;
    joined_.push_back(part);
  }

  Member_index label_of(Position v) const
  {
    const auto it = numbers_.find(v);
    return it == numbers_.end() || !is_swept_[it->second] ? Member_index(no_index) : it->second;
  }

  Vertex_ring make_ring(Position v, Side side) const
  {
    Vertex_ring ring;
    for(const auto& neighbor : graph_.neighbors(v))
    {
      if(!is_on(neighbor.vertex, side))
        continue;
      ring.parents.push_back(ring.vertices.size());
      ring.vertices.push_back(neighbor.vertex);
      ring.labels.push_back(label_of(neighbor.vertex));
    }
    for(const Face_index t : triangles_.triangles_at(v))
    {
      const auto& triangle = triangles_[t];
      const int corner = triangle.corner(v);
      const Position a = triangle.vertices[(corner + 1) % 3], b = triangle.vertices[(corner + 2) % 3];
      if(is_on(a, side) && is_on(b, side))
        ring.unite(a, b);
    }
    return ring;
  }

  // Follows the contours at v until they come back to it or end at the border.
  Vertex_contours trace_contours(Position v, Side side) const
  {
    Vertex_ring ring = make_ring(v, side);
    for(const Face_index t : triangles_.triangles_at(v))
    {
      const int corner = triangles_[t].corner(v);
      const Position a = triangles_[t].vertices[(corner + 1) % 3], b = triangles_[t].vertices[(corner + 2) % 3];
      if(is_on(a, side) != is_on(b, side))
        trace(v, t, is_on(a, side) ? a : b, is_on(a, side) ? b : a, side, ring);
    }
    return ring.contours();
  }

  // Follows one of them from a triangle at v, out over the edge from `inside`, which is on its side, to `outside`.
  void trace(Position v, Face_index t, Position inside, Position outside, Side side, Vertex_ring& ring) const
  {
    const Position first = inside;
    Member_index label = no_index;
    Position crossed = v; // faces the edge
    for(;;)
    {
      if(label == no_index)
        label = label_of(inside);
      t = triangles_[t].neighbors[triangles_[t].corner(crossed)];
      if(t == no_index || triangles_[t].contains(v))
        break;
      const auto& vertices = triangles_[t].vertices;
      const Position third = vertices[0] != inside && vertices[0] != outside ? vertices[0]
                           : vertices[1] != inside && vertices[1] != outside ? vertices[1]
                                                                             : vertices[2];
      Position& replaced = is_on(third, side) ? inside : outside;
      crossed = replaced;
      replaced = third;
    }
    ring.label(ring.find(ring.index(first)), label);
    if(t != no_index)
      ring.unite(first, inside);
  }

  const scalar_fields::Weighted_graph& graph_;
  const Triangle_neighbors& triangles_;
  const IsLower& is_lower_;
  Indexed_vector<Member_index, Position> members_;
  std::unordered_map<Position, Member_index> numbers_;
  Indexed_vector<Member_index, bool> is_swept_;
  std::vector<Member_index> swept_;
  Indexed_vector<Member_index, Member_index>
    parents_;                                       // in the parts, without shortcuts, so that steps can be taken back
  Indexed_vector<Member_index, std::size_t> sizes_; // of the parts, at their roots
  std::vector<Member_index> joined_;                // what each step has joined, each time behind no_index
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PIECE_SWEEP_H
