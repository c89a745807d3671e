// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_UNCHECKED_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_UNCHECKED_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// The fans of some vertices: how many corners of triangles they have, how many fans are at the border, and how many
// have other faces.
struct Fan_counts
{
  std::size_t corners = 0;
  std::size_t border_fans = 0;
  std::size_t bad_fans = 0;

  Fan_counts& operator+=(const Fan_counts& other)
  {
    corners += other.corners;
    border_fans += other.border_fans;
    bad_fans += other.bad_fans;
    return *this;
  }
};

struct No_visitor_of_fan
{
  void begin(Vertex_index) {}
  void add(Vertex_index) {}
};

// A complex that may be none, as its faces may have more than three corners and its vertices more than one fan. The fan
// of each vertex has to be set, in any order; then check() gives the complex.
template <class Complex>
class Unchecked_complex
{
public:
  explicit Unchecked_complex(Complex complex) : complex_(std::move(complex)) {}

  Number number_of_vertices() const { return complex_.number_of_vertices(); }
  bool has_vertex(Vertex_index number) const { return complex_.has_vertex(number); }

  // The complex as far as it goes: only vertices whose fans have been set may be asked about.
  const Complex& at_set_fans() const { return complex_; }

  // Sets the fan of a vertex that is known to have one only, inside of the surface, to begin with the halfedge that the
  // mesh keeps for it, which ends there.
  void set_closed_fan(Vertex_index vertex) { complex_.first_halfedges_[vertex] = complex_.kept_halfedge(vertex); }

  // Turns to the halfedge with which the fan of a vertex begins, keeps it, and adds to `counts`.
  //
  // Shows the neighbors on the way, in clockwise order: visitor.begin(neighbor), then visitor.add(neighbor) for each
  // next one. Returns whether that has led back to the first one, as it does inside of the surface.
  template <class Visitor>
  bool set_fan(Vertex_index vertex, Fan_counts& counts, Visitor& visitor)
  {
    Halfedge_index& first = complex_.first_halfedges_[vertex];
    first = complex_.halfedge_of_face_at(vertex);
    if(first == no_index)
      return false;
    if(complex_.target(first) != vertex)
      return give_up(first, counts);
    visitor.begin(complex_.source(first));
    Halfedge_index halfedge = first;
    do
    {
      const Halfedge_index second = complex_.next(halfedge);
      if(!is_in_triangle(halfedge))
        return give_up(first, counts);
      ++counts.corners;
      visitor.add(complex_.target(second));
      halfedge = opposite_of(second);
    } while(halfedge != first && complex_.has_triangle(halfedge));
    if(halfedge == first)
      return true;
    for(; complex_.has_triangle(opposite_of(first)); ++counts.corners)
    {
      // Steps backwards undo those onwards. If they meet the end of these, it is a border that the other side does not
      // have.
      const Halfedge_index turned = complex_.previous(opposite_of(first));
      if(!is_in_triangle(opposite_of(first)) || !is_in_triangle(turned) || !complex_.has_triangle(turned)
         || complex_.next(turned) != opposite_of(first))
        return give_up(first, counts);
      first = turned;
    }
    ++counts.border_fans;
    return false;
  }

  // The complex, if the sums of the counts are right. Throws if a face is no triangle, or has a corner that belongs to
  // no fan: a mesh leads to one fan per vertex only, but there may be more. Throws if an edge has no face.
  Complex check(const Fan_counts& counts) &&
  {
    if(counts.bad_fans != 0 || !complex_.has_no_others(counts.corners, counts.border_fans))
    {
      complex_.check_faces();
      complex_.check_edges();
      throw_non_manifold_vertex_error();
    }
    return std::move(complex_);
  }

private:
  // Ends a turn that might never end, as it has met a halfedge that is none of a triangle at the vertex.
  static bool give_up(Halfedge_index& first, Fan_counts& counts)
  {
    first = no_index;
    ++counts.bad_fans;
    return false;
  }

  // Whether the face of the halfedge is a triangle with different vertices at this halfedge's ends.
  bool is_in_triangle(Halfedge_index halfedge) const
  {
    const Halfedge_index second = complex_.next(halfedge), third = complex_.next(second);
    return second != halfedge && third != halfedge && complex_.next(third) == halfedge
        && complex_.target(halfedge) != complex_.target(third);
  }

  void throw_non_manifold_vertex_error() const
  {
    Indexed_vector<Vertex_index, Number> unreached(number_of_vertices(), 0);
    for(const Halfedge_index h : Index_range<Halfedge_index>(complex_.number_of_halfedges()))
    {
      if(complex_.has_edge(edge_of(h)) && complex_.has_triangle(h) && complex_.has_star(complex_.target(h)))
        ++unreached[complex_.target(h)];
    }
    for(const Vertex_index v : complex_.vertices())
    {
      if(has_vertex(v))
        complex_.for_each_halfedge_around(v, [&](Halfedge_index) { --unreached[v]; });
      if(unreached[v] != 0)
        throw Non_manifold_vertex_error(complex_.position(v));
    }
  }

  Complex complex_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_UNCHECKED_COMPLEX_H
