// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DESCRIPTOR_LIST_H
#define CGAL_REEB_GRAPH_INTERNAL_DESCRIPTOR_LIST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Large_vector.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether the descriptors of each kind of elements of a mesh are made from the numbers 0, 1, 2, ..., in the order of
// the elements. Then there is no need to store them, and any of them can be had from any thread.
template <class Mesh>
struct Consecutive_descriptors
{
  static constexpr bool are_possible = false;
  static bool are_in(const Mesh&) { return false; }
};

template <class Point>
struct Consecutive_descriptors<Surface_mesh<Point>>
{
  static constexpr bool are_possible = true;
  static bool are_in(const Surface_mesh<Point>& mesh) { return !mesh.has_garbage(); }
};

// The descriptors of vertices(mesh), for example, by position.
template <class Mesh, class Descriptor>
class Descriptor_list
{
public:
  template <class Range>
  Descriptor_list(const Mesh& mesh, const Range& range)
  {
    if(Consecutive_descriptors<Mesh>::are_in(mesh))
      size_ = range.size();
    else
    {
      stored_.assign(range.begin(), range.end());
      size_ = stored_.size();
    }
  }

  std::size_t size() const { return size_; }
  bool is_consecutive() const { return stored_.size() != size_; }

  Descriptor operator[](std::size_t position) const
  {
    if constexpr(Consecutive_descriptors<Mesh>::are_possible)
    {
      if(is_consecutive())
        return Descriptor(static_cast<typename Mesh::size_type>(position));
    }
    return stored_[position];
  }

private:
  std::size_t size_ = 0;
  Large_vector<Descriptor> stored_; // empty if consecutive
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DESCRIPTOR_LIST_H
