// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_QUERIES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_QUERIES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/combine_trees.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// By vertex, the arc between critical vertices that it is on; no_index if it is critical.
typedef Indexed_vector<Vertex_index, Slab_arc_index> Arc_of_vertex;

// What the engine is asked besides the arcs between critical vertices: nothing.
class No_vertex_queries
{
public:
  static constexpr bool are_any = false;

  struct Answers
  {
    void find_next() {}
  };

  template <Side, class Sweep>
  Answers answers(Sweep&)
  {
    return Answers();
  }
};

// Asks the sweeps for the regular vertices, each at its place in the order of the field: its class in a merge tree is
// the top of the component that it is in. The two classes tell its arc.
template <class Complex, class Order>
class Vertex_queries
{
  struct Query_tag;
  typedef Index_of<Query_tag> Query;

public:
  static constexpr bool are_any = true;

  Vertex_queries(const Complex& complex, const Order& order, const Swept_vertices& critical_vertices)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices)
  {
    find_vertices();
  }

  // Puts the vertices, which are in the order of the mesh so far, in that of the field.
  template <class ConcurrencyTag>
  void sort()
  {
    typedef typename Order::template Key<Vertex_index> Key;
    Vector_of<Key> keys(vertices_.size());
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        keys[i] = order_.key(vertices_[Query(i)], vertices_[Query(i)]);
    });
    internal::sort<ConcurrencyTag>(keys.begin(), keys.end(), order_);
    find_bounds(keys);
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        vertices_[Query(i)] = keys[i].name;
    });
    for(const Side side : both_sides)
      classes_[side].renew(vertices_.size(), no_index);
  }

  // What a sweep answers, that for the join tree, which comes from below, or that for the split tree.
  template <Side side, class Sweep>
  class Answers
  {
  public:
    Answers(Vertex_queries& queries, Sweep& sweep)
      : queries_(queries),
        sweep_(sweep),
        place_(side == Side::LOWER ? 1 : queries.bounds_.size() - 2),
        next_(queries.bounds_[place_])
    {}

    // Goes on to the next critical vertex, when the sweep has visited one.
    void find_next()
    {
      place_ = moved(place_, 1);
      for(; next_ != queries_.bounds_[place_]; next_ = moved(next_, 1))
        find(side == Side::LOWER ? next_ : next_ - 1);
    }

  private:
    // Below zero, the result is larger than all places.
    static std::size_t moved(std::size_t i, std::size_t steps) { return side == Side::LOWER ? i + steps : i - steps; }

    void find(std::size_t i)
    {
      constexpr std::size_t far_ahead = 16, ahead = 8;
      const auto& vertices = queries_.vertices_;
      if(moved(i, far_ahead) < vertices.size())
        sweep_.prefetch_path_end(vertices[Query(moved(i, far_ahead))]);
      if(moved(i, ahead) < vertices.size())
        sweep_.prefetch_component(vertices[Query(moved(i, ahead))]);
      queries_.classes_[side][Query(i)] = sweep_.class_of(vertices[Query(i)]);
    }

    Vertex_queries& queries_;
    Sweep& sweep_;
    std::size_t place_;
    std::size_t next_;
  };

  template <Side side, class Sweep>
  Answers<side, Sweep> answers(Sweep& sweep)
  {
    return Answers<side, Sweep>(*this, sweep);
  }

  // Finds the arcs of the vertices when all of them have been asked for.
  //
  // When the arc of a vertex is taken from what is left of the trees, it is that of a leaf, say an upper one: then all
  // that is left above the vertex is the rest of this arc, and the vertex is on the arc of the leaf in the split tree.
  // No earlier leaf has the vertex on its arc in either tree: all that was left on one side of it would have been the
  // rest of that leaf's arc. So the arc is the first one that a class of the vertex has gone to.
  template <class ConcurrencyTag>
  void find_arcs(const Arcs_of_classes& arcs_of_classes)
  {
    arc_of_vertex_.assign(complex_.number_of_vertices(), no_index);
    constexpr std::size_t ahead = 16;
    for_each_block<ConcurrencyTag>(vertices_.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
      {
        if(i + ahead < end)
        {
          for(const Side side : both_sides)
            prefetch_element(arcs_of_classes[side], classes_[side][Query(i + ahead)]);
          prefetch_element(arc_of_vertex_, vertices_[Query(i + ahead)]);
        }
        Slab_arc_index arc = no_index;
        for(const Side side : both_sides)
        {
          const Slab_node node = classes_[side][Query(i)];
          if(node != no_index)
            arc = (std::min)(arc, arcs_of_classes[side][node]);
        }
        arc_of_vertex_[vertices_[Query(i)]] = arc;
      }
    });
  }

  // The arcs that have been found. With an order that contradicts itself, some may be missing.
  Arc_of_vertex take_arc_of_vertex() { return std::move(arc_of_vertex_); }

private:
  void find_vertices()
  {
    vertices_.resize(complex_.number_of_vertices());
    std::size_t size = 0;
    Swept_index critical(0);
    for(const Vertex_index vertex : complex_.vertices())
    {
      const bool is_critical =
        critical.number() != critical_vertices_.size() && critical_vertices_.vertex(critical) == vertex;
      critical = Swept_index(critical.number() + (is_critical ? 1 : 0));
      vertices_[Query(size)] = vertex;
      size += !is_critical && complex_.has_vertex(vertex) ? 1 : 0;
    }
    vertices_.resize(size);
  }

  template <class Keys>
  void find_bounds(const Keys& keys)
  {
    constexpr std::size_t far_ahead = 32, ahead = 16;
    const Plain_vector<Swept_index>& ascending = critical_vertices_.ascending();
    bounds_.reserve(ascending.size() + 2);
    bounds_.push_back(0);
    std::size_t end = 0;
    for(std::size_t i = 0; i != ascending.size(); ++i)
    {
      if(i + far_ahead < ascending.size())
        critical_vertices_.prefetch(ascending[i + far_ahead]);
      if(i + ahead < ascending.size())
        order_.prefetch(critical_vertices_.vertex(ascending[i + ahead]));
      const Vertex_index vertex = critical_vertices_.vertex(ascending[i]);
      const auto key = order_.key(vertex, vertex);
      while(end != keys.size() && order_(keys[end], key))
        ++end;
      bounds_.push_back(static_cast<Number>(end));
    }
    bounds_.push_back(static_cast<Number>(keys.size()));
  }

  const Complex& complex_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Query, Vertex_index> vertices_; // in ascending order, when sorted
  Plain_vector<Number> bounds_; // 0, how many are below each critical vertex in ascending order, the number of all
  By_side<Indexed_vector<Query, Slab_node>> classes_;
  Arc_of_vertex arc_of_vertex_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_VERTEX_QUERIES_H
