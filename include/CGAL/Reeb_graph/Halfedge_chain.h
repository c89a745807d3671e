// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HALFEDGE_CHAIN_H
#define CGAL_REEB_GRAPH_HALFEDGE_CHAIN_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphRef
///
/// \brief an immutable sequence of ascending halfedges; see `Arc::chain`.
///
/// All chains of a graph share one block of memory, which lives as long as one of them: a chain costs 24 bytes
/// and the size of its halfedges, and copying one copies no halfedge.
///
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
///
/// \cgalModels{RandomAccessRange}
template <class HalfedgeDescriptor>
class Halfedge_chain
{
public:
  typedef HalfedgeDescriptor value_type;            ///< the type of the elements
  typedef const HalfedgeDescriptor* const_iterator; ///< the iterator type; elements cannot be changed
  typedef const_iterator iterator;                  ///< the same
  typedef std::size_t size_type;                    ///< the type of the size
  typedef std::ptrdiff_t difference_type;           ///< the type of the distance of two iterators
  typedef const HalfedgeDescriptor& reference;      ///< the type of an access
  typedef reference const_reference;                ///< the same

  /// constructs an empty chain.
  Halfedge_chain() = default;

#ifndef DOXYGEN_RUNNING
  Halfedge_chain(const Halfedge_chain&) = default;
  Halfedge_chain& operator=(const Halfedge_chain&) = default;
  Halfedge_chain(Halfedge_chain&& other) noexcept { *this = std::move(other); }
  Halfedge_chain& operator=(Halfedge_chain&& other) noexcept
  {
    first_ = std::move(other.first_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
#endif

  /// constructs the chain of the elements `first` to `first + size - 1` of `storage`.
  Halfedge_chain(const std::shared_ptr<const std::vector<HalfedgeDescriptor>>& storage, size_type first, size_type size)
    : first_(storage, storage->data() + first),
      size_(size)
  {}

  const_iterator begin() const { return first_.get(); }          ///< the first halfedge
  const_iterator end() const { return first_.get() + size_; }    ///< past the last halfedge
  size_type size() const { return size_; }                       ///< the number of halfedges
  bool empty() const { return size_ == 0; }                      ///< whether there is no halfedge
  reference operator[](size_type i) const { return begin()[i]; } ///< the halfedge number `i`
  reference front() const { return *begin(); }                   ///< the first halfedge
  reference back() const { return end()[-1]; }                   ///< the last halfedge

  /// returns `true` if both chains are the same sequence of halfedges.
  friend bool operator==(const Halfedge_chain& a, const Halfedge_chain& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

  /// returns `true` if the chains are different sequences.
  friend bool operator!=(const Halfedge_chain& a, const Halfedge_chain& b) { return !(a == b); }

private:
  std::shared_ptr<const HalfedgeDescriptor> first_;
  size_type size_ = 0;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HALFEDGE_CHAIN_H
