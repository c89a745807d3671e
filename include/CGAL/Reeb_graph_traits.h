// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TRAITS_H
#define CGAL_REEB_GRAPH_TRAITS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/options.h>

#include <boost/container/small_vector.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/properties.hpp>
#include <boost/pending/container_traits.hpp>
#include <boost/pending/property.hpp>
#include <boost/pool/pool.hpp>

#include <algorithm>
#include <cstddef>
#include <forward_list>
#include <functional>
#include <list>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

// How a Reeb graph is stored: with the containers that are usual for an adjacency list, the many arcs of a noisy field
// would take most of the time that the whole graph takes, for allocations and new pages of memory.

namespace CGAL::Reeb_graph::internal {

// The arcs at one side of a node. There are rarely more than two of them.
template <class T>
class Inline_edge_list : public boost::container::small_vector<T, 2>
{
};

// How Boost.Graph is told to handle a container of its users as a vector.
template <class T>
boost::graph_detail::vector_tag container_category(const Inline_edge_list<T>&)
{
  return boost::graph_detail::vector_tag();
}
template <class T>
boost::graph_detail::unstable_tag iterator_stability(const Inline_edge_list<T>&)
{
  return boost::graph_detail::unstable_tag();
}

// The large blocks from which the allocators of one container take single objects, of one size or of several.
class Block_pools
{
  // The number of objects in a block, which is written to when it is taken.
  static constexpr std::size_t smallest_block = 8, largest_block = 100000;

public:
  typedef boost::pool<boost::default_user_allocator_malloc_free> Pool;

  Pool& pool_of(std::size_t size_of_object)
  {
    for(Pool& pool : pools_)
    {
      if(pool.get_requested_size() == size_of_object)
        return pool;
    }
    return pools_.emplace_front(size_of_object, +smallest_block, +largest_block);
  }

private:
  std::forward_list<Pool> pools_; // a few, which stay where they are
};

// Takes single objects from blocks. Copied allocators share them, those for other types, too; copied containers do not.
template <class T>
class Block_allocator
{
  template <class U>
  friend class Block_allocator;

public:
  typedef T value_type;
  typedef std::true_type propagate_on_container_move_assignment;
  typedef std::true_type propagate_on_container_swap;
  typedef std::false_type is_always_equal;

  Block_allocator() : Block_allocator(std::make_shared<Block_pools>()) {}
  Block_allocator(const Block_allocator&) = default; // and no move, which would leave an allocator without a pool
  Block_allocator& operator=(const Block_allocator&) = default;
  template <class U>
  Block_allocator(const Block_allocator<U>& other) : Block_allocator(other.pools_)
  {}

  Block_allocator select_on_container_copy_construction() const { return Block_allocator(); }

  T* allocate(std::size_t size)
  {
    if(size != 1)
      return std::allocator<T>().allocate(size);
    void* place = (pool_->malloc)();
    if(place == nullptr)
      throw std::bad_alloc();
    return static_cast<T*>(place);
  }

  void deallocate(T* place, std::size_t size)
  {
    if(size != 1)
      std::allocator<T>().deallocate(place, size);
    else
      (pool_->free)(place);
  }

  template <class U>
  bool operator==(const Block_allocator<U>& other) const
  {
    return pools_ == other.pools_;
  }
  template <class U>
  bool operator!=(const Block_allocator<U>& other) const
  {
    return !(*this == other);
  }

private:
  explicit Block_allocator(std::shared_ptr<Block_pools> pools)
    : pools_(std::move(pools)),
      pool_(&pools_->pool_of(sizeof(T)))
  {}

  std::shared_ptr<Block_pools> pools_;
  Block_pools::Pool* pool_; // that of the objects
};

struct Inline_edge_list_selector
{
};
struct Block_list_selector
{
};

} // namespace CGAL::Reeb_graph::internal

namespace boost {

template <class T>
struct container_gen<CGAL::Reeb_graph::internal::Inline_edge_list_selector, T>
{
  typedef CGAL::Reeb_graph::internal::Inline_edge_list<T> type;
};

template <>
struct parallel_edge_traits<CGAL::Reeb_graph::internal::Inline_edge_list_selector>
{
  typedef allow_parallel_edge_tag type;
};

template <class T>
struct container_gen<CGAL::Reeb_graph::internal::Block_list_selector, T>
{
  typedef std::list<T, CGAL::Reeb_graph::internal::Block_allocator<T>> type;
};

} // namespace boost

namespace CGAL {
namespace Reeb_graph {

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

/// \ingroup PkgReebGraphRef
///
/// \brief the bundled property of a node of the Reeb graph.
///
/// \tparam VertexDescriptor a vertex descriptor of the mesh
/// \tparam Scalar_ a scalar type
template <class VertexDescriptor, class Scalar_>
struct Node
{
  /// the scalar value at the vertex
  Scalar_ value = Scalar_();
  /// the vertex of the mesh; with `Ties::CONTRACT` the lowest critical one of those that the node stands for
  VertexDescriptor vertex = VertexDescriptor();
  /// what happens to the contours there
  Node_kind kind = Node_kind::ISOLATED;
};

/// \ingroup PkgReebGraphRef
///
/// \brief the bundled property of an arc of the Reeb graph.
///
/// The chain leads from the graph back to the mesh: `get(&Arc::chain, graph)` is a property map from the arcs
/// to their chains.
///
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class HalfedgeDescriptor>
struct Arc
{
  /// ascending halfedges from the vertex of the lower node to the first one that crosses the level just below
  /// the upper node. With `Ties::CONTRACT` the chain begins at a vertex of the lower node. It has several segments where
  /// the arc passes a plateau: each but the first begins at the vertex of the plateau from which the arc goes on.
  Halfedge_chain<HalfedgeDescriptor> chain;
};

namespace internal {

template <class Node, class Arc>
using Stored_graph = boost::adjacency_list<Inline_edge_list_selector,
                                           boost::vecS,
                                           boost::bidirectionalS,
                                           Node,
                                           boost::property<boost::edge_index_t, std::size_t, Arc>,
                                           boost::no_property,
                                           Block_list_selector>;

// The graph of a Surface_mesh, whatever its points are.
template <class Scalar>
using Surface_graph = Stored_graph<Node<SM_Vertex_index, Scalar>, Arc<SM_Halfedge_index>>;

} // namespace internal

} // namespace Reeb_graph

/// \ingroup PkgReebGraphRef
///
/// \brief the types and predicates of a Reeb graph of a scalar field on a triangle mesh.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of `FaceListGraph` as key
///         type, and with a value type that has `operator<` as strict weak order: built-in numbers, number types
///         of \cgal, or a type of the user. To order by another function object, derive from this class.
///
/// \cgalModels{ReebGraphTraits}
template <class FaceListGraph, class ScalarMap>
class Reeb_graph_traits
{
public:
  /// the type of the mesh
  typedef FaceListGraph Triangle_mesh;
  /// the type of the scalar field
  typedef ScalarMap Scalar_map;
  /// the type of a scalar value
  typedef typename Reeb_graph::internal::Value_of_map<ScalarMap>::type Scalar;

  /// the vertex descriptor of the mesh
  typedef typename Reeb_graph::internal::Descriptors<FaceListGraph>::vertex_descriptor vertex_descriptor;
  /// the halfedge descriptor of the mesh
  typedef typename Reeb_graph::internal::Descriptors<FaceListGraph>::halfedge_descriptor halfedge_descriptor;

  /// the property of a node
  typedef Reeb_graph::Node<vertex_descriptor, Scalar> Node;
  /// the property of an arc
  typedef Reeb_graph::Arc<halfedge_descriptor> Arc;
  /// the Reeb graph. Arcs are directed from the lower to the upper node, and can be parallel. They are stored in a way
  /// that saves allocations. Any other containers of Boost.Graph that allow parallel edges can be used as well.
  ///
  /// `get(boost::edge_index, graph)` is a property map from the arcs to their numbers, from 0, in the order of
  /// `edges(graph)`, as the functions that write a graph have set them; `graph[arc]` is the `Arc`.
#ifdef DOXYGEN_RUNNING
  typedef boost::adjacency_list<unspecified_type,
                                boost::vecS,
                                boost::bidirectionalS,
                                Node,
                                boost::property<boost::edge_index_t, std::size_t, Arc>>
    Graph;
#else
  typedef Reeb_graph::internal::Stored_graph<Node, Arc> Graph;
#endif

  /// the strict weak order of the scalar values
  typedef std::less<Scalar> Less_scalar;

  /// the test that a value has a place in the order
  struct Is_ordered
  {
    /// returns `false` for NaN, and for a `std::pair`, `std::tuple` or `std::array` with NaN inside, `true` for any
    /// other value, infinities included.
    bool operator()(const Scalar& a) const { return Reeb_graph::internal::is_ordered(a); }
  };

  /// returns the order.
  Less_scalar less_scalar_object() const { return Less_scalar(); }
  /// returns the test.
  Is_ordered is_ordered_object() const { return Is_ordered(); }
};

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_TRAITS_H
