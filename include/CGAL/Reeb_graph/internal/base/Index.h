// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Reeb_graph::internal {

// Integers have three names. An Index is a number of things of a mesh, or how many they are: 32 bits are half the memory
// traffic of the sweeps.
typedef std::uint32_t Index;

// A number of things of all ranks together, or a place in an order in which others are put later.
typedef std::uint64_t Long_index;

// The null value of all kinds of indices.
struct No_index
{
  constexpr operator Index() const { return (std::numeric_limits<Index>::max)(); }
};
inline constexpr No_index no_index = {};

// The index of one of many things of the kind that `Tag` names. There is no way from one kind to another, nor to a
// number, but an explicit one. As a number, it is unset if no value is given.
template <class Tag>
class Index_of
{
public:
  Index_of() = default;
  constexpr Index_of(No_index) : number_(No_index()) {}
  explicit constexpr Index_of(std::size_t number) : number_(static_cast<Index>(number)) {}

  constexpr Index number() const { return number_; }

  Index_of& operator++()
  {
    ++number_;
    return *this;
  }

  friend constexpr bool operator==(Index_of a, Index_of b) { return a.number_ == b.number_; }
  friend constexpr bool operator!=(Index_of a, Index_of b) { return a.number_ != b.number_; }
  friend constexpr bool operator<(Index_of a, Index_of b) { return a.number_ < b.number_; }
  friend constexpr bool operator>(Index_of a, Index_of b) { return a.number_ > b.number_; }
  friend constexpr bool operator<=(Index_of a, Index_of b) { return a.number_ <= b.number_; }
  friend constexpr bool operator>=(Index_of a, Index_of b) { return a.number_ >= b.number_; }

private:
  Index number_;
};

// An index of any kind as a number.
constexpr Index number_of(Index index) { return index; }
template <class Tag>
constexpr Index number_of(Index_of<Tag> index)
{
  return index.number();
}

// The indices from `begin` up to the one before `end`.
template <class Key>
class Index_range
{
public:
  struct iterator
  {
    Key key;

    Key operator*() const { return key; }
    iterator& operator++()
    {
      ++key;
      return *this;
    }
    friend bool operator!=(iterator a, iterator b) { return a.key != b.key; }
  };

  Index_range(Key begin, Key end) : begin_{begin}, end_{end} {}
  explicit Index_range(std::size_t size) : Index_range(Key(0), Key(static_cast<Index>(size))) {}

  iterator begin() const { return begin_; }
  iterator end() const { return end_; }

private:
  iterator begin_, end_;
};

// Throws if there are more things than indices.
inline Index checked_index(std::size_t size)
{
  if(size >= (std::numeric_limits<Index>::max)())
    throw Mesh_size_error();
  return static_cast<Index>(size);
}

// The side of a level, or of a vertex.
enum class Side : unsigned char
{
  LOWER,
  UPPER
};

inline constexpr std::array<Side, 2> both_sides = {Side::LOWER, Side::UPPER};

constexpr Side side_of(bool is_upper) { return is_upper ? Side::UPPER : Side::LOWER; }
constexpr Side opposite_of(Side side) { return side_of(side == Side::LOWER); }

// Two elements, one for each side, the lower one first.
template <class T>
struct By_side
{
  std::array<T, 2> elements;

  constexpr T& operator[](Side side) { return elements[static_cast<std::size_t>(side)]; }
  constexpr const T& operator[](Side side) const { return elements[static_cast<std::size_t>(side)]; }
};

// Names of the elements of a mesh. The stages know nothing else of them.
struct Vertex_tag;
struct Halfedge_tag;
struct Edge_tag;
struct Face_tag;
struct Triangle_tag;
struct Node_tag;
struct Arc_tag;
typedef Index_of<Vertex_tag> Vertex_index;
typedef Index_of<Halfedge_tag> Halfedge_index;
typedef Index_of<Edge_tag> Edge_index;
typedef Index_of<Face_tag> Face_index;
typedef Index_of<Triangle_tag> Triangle_index; // of a complex that may be no surface
typedef Index_of<Node_tag> Node_index;         // of a Reeb graph
typedef Index_of<Arc_tag> Arc_index;

// The two halfedges of edge e are 2 e and 2 e + 1.
constexpr Edge_index edge_of(Halfedge_index halfedge) { return Edge_index(halfedge.number() / 2); }
constexpr Halfedge_index opposite_of(Halfedge_index halfedge) { return Halfedge_index(halfedge.number() ^ 1); }
constexpr Halfedge_index even_halfedge(Edge_index edge) { return Halfedge_index(std::size_t(2) * edge.number()); }

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_INDEX_H
