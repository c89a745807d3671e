// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_OPPOSITE_SIDES_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_OPPOSITE_SIDES_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Elements that go to two sides, and what is known of pairs of them: that they are on one side, or on opposite ones. A
// union-find in which each element knows its side, seen from the root.
class Opposite_sides
{
public:
  explicit Opposite_sides(std::size_t size) : parents_(size), sizes_(size, 1), is_opposite_(size, false)
  {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }

  std::size_t size() const { return parents_.size(); }

  // The root of an element, and whether the two are on opposite sides.
  std::pair<std::size_t, bool> find(std::size_t element) const
  {
    bool is_opposite = false;
    for(; parents_[element] != element; element = parents_[element])
      is_opposite ^= is_opposite_[element];
    return {element, is_opposite};
  }

  // Two elements that are already related stay as they are, also if that contradicts.
  void relate(std::size_t a, std::size_t b, bool are_opposite)
  {
    auto [root, is_opposite] = find(a);
    auto [other_root, is_other_opposite] = find(b);
    if(root == other_root)
      return;
    if(sizes_[root] < sizes_[other_root])
      std::swap(root, other_root);
    parents_[other_root] = root;
    sizes_[root] += sizes_[other_root];
    is_opposite_[other_root] = is_opposite ^ is_other_opposite ^ are_opposite;
  }

private:
  std::vector<std::size_t> parents_, sizes_;
  std::vector<bool> is_opposite_; // to the parent
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_OPPOSITE_SIDES_H
