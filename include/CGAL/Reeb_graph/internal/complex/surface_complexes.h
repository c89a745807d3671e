// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SURFACE_COMPLEXES_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SURFACE_COMPLEXES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

template <class Complex>
class Unchecked_complex;

// Some triangles, as they are in memory. The vertices are those at which the halfedges end.
struct Triangle_block
{
  struct Triangle
  {
    std::array<Halfedge_index, 3> halfedges; // one after another
    std::array<Vertex_index, 3> vertices;
  };

  static constexpr std::size_t capacity = 16; // What is read of a block stays in the first caches.

  std::array<Triangle, capacity> triangles;
  std::size_t size = 0;
};

// An oriented triangulated surface by numbers, as the stages see it. A halfedge has its triangle on the left, or none,
// along the border. There may be numbers that belong to no vertex and to no edge.
//
// A class `Complex` derived from this one has number_of_halfedges(), target(halfedge), has_triangle(halfedge),
// next(halfedge), for a halfedge of a triangle, and has_vertex(number) and has_edge(number); and for Unchecked_complex,
// number_of_faces(), number_of_live_edges(), halfedge_of_face_at(vertex), any one that ends there or no_index,
// check_faces(), which throws if a face is no triangle with three vertices, and check_edges(), if an edge has no face.
template <class Complex>
class Triangle_complex_base
{
public:
  // Whether each edge has one or two triangles, and each vertex one fan of them.
  static constexpr bool is_surface = true;

  // The first number behind those of the vertices, or of the edges.
  Index number_of_vertices() const { return static_cast<Index>(first_halfedges_.size()); }
  Index number_of_edges() const { return complex().number_of_halfedges() / 2; }
  Index_range<Vertex_index> vertices() const { return Index_range<Vertex_index>(number_of_vertices()); }

  Vertex_index source(Halfedge_index halfedge) const { return complex().target(opposite_of(halfedge)); }

  bool is_on_border_edge(Halfedge_index halfedge) const
  {
    return !complex().has_triangle(halfedge) || !complex().has_triangle(opposite_of(halfedge));
  }

  bool is_on_triangle(Edge_index edge) const
  {
    const Halfedge_index even = even_halfedge(edge);
    return complex().has_edge(edge) && (complex().has_triangle(even) || complex().has_triangle(opposite_of(even)));
  }
  // One halfedge of an edge that is on a triangle.
  Halfedge_index halfedge_of_triangle(Edge_index edge) const
  {
    const Halfedge_index even = even_halfedge(edge);
    return complex().has_triangle(even) ? even : opposite_of(even);
  }

  // The halfedge before, in the triangle of the halfedge.
  Halfedge_index previous(Halfedge_index halfedge) const { return complex().next(complex().next(halfedge)); }

  // Triangles have numbers below this one, though not all such numbers belong to one. Here they are those of their least
  // halfedges.
  Index end_of_triangles() const { return complex().number_of_halfedges(); }

  // Reads the triangles whose numbers are from `begin` to `end`, which are at most the capacity of a block. Returns
  // whether all is right with them; each of their halfedges is then on no other one.
  bool read_triangles(std::size_t begin, std::size_t end, Triangle_block& block) const
  {
    block.size = 0;
    for(const Halfedge_index h : Index_range(Halfedge_index(begin), Halfedge_index(end)))
    {
      if(!complex().has_triangle(h))
        continue;
      const Halfedge_index second = complex().next(h), third = complex().next(second);
      block.triangles[block.size].halfedges = {h, second, third};
      block.size += h < second && h < third ? 1 : 0; // without a branch, as none could be foreseen
    }
    for(std::size_t i = 0; i != block.size; ++i)
      for(std::size_t k = 0; k != 3; ++k)
        block.triangles[i].vertices[k] = complex().target(block.triangles[i].halfedges[k]);
    return true;
  }

  // A halfedge that the mesh keeps for a vertex: if it is on a triangle and ends there, halfedge_of_face_at(vertex).
  Halfedge_index kept_halfedge(Vertex_index vertex) const { return first_halfedges_[vertex]; }

  // A halfedge of a triangle that ends at `vertex`, no_index if there is none. At a border vertex it is the one from
  // which turning clockwise meets all others.
  Halfedge_index first_halfedge(Vertex_index vertex) const { return first_halfedges_[vertex]; }

  // The next halfedge with the same target, clockwise. Behind the border it has no triangle.
  Halfedge_index clockwise(Halfedge_index halfedge) const { return opposite_of(complex().next(halfedge)); }

  bool is_on_border(Vertex_index vertex) const
  {
    const Halfedge_index halfedge = first_halfedge(vertex);
    return halfedge != no_index && !complex().has_triangle(opposite_of(halfedge));
  }

  // Calls visit(neighbor, halfedge), where `halfedge` is a halfedge of a triangle on the edge to `neighbor`, for the
  // edges at `vertex`, turning clockwise, at a border vertex from border edge to border edge, until a call returns
  // true.
  template <class Visit>
  void visit_edges_around(Vertex_index vertex, const Visit& visit) const
  {
    const Halfedge_index first = first_halfedge(vertex);
    for(Halfedge_index halfedge = first; halfedge != no_index;)
    {
      if(visit(source(halfedge), halfedge))
        return;
      const Halfedge_index turned = clockwise(halfedge);
      if(turned == first)
        return;
      if(!complex().has_triangle(turned))
      {
        visit(source(turned), opposite_of(turned));
        return;
      }
      halfedge = turned;
    }
  }

  // Calls visit(neighbor, halfedge) in the same way for each edge at `vertex`.
  template <class Visit>
  void for_each_edge_around(Vertex_index vertex, const Visit& visit) const
  {
    visit_edges_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
      visit(neighbor, halfedge);
      return false;
    });
  }

  // Calls visit(halfedge) for the halfedges of triangles that end at `vertex`, clockwise.
  template <class Visit>
  void for_each_halfedge_around(Vertex_index vertex, const Visit& visit) const
  {
    const Halfedge_index first = first_halfedge(vertex);
    for(Halfedge_index halfedge = first; halfedge != no_index;)
    {
      visit(halfedge);
      halfedge = clockwise(halfedge);
      if(halfedge == first || !complex().has_triangle(halfedge))
        return;
    }
  }

  // Whether the face of the halfedge has three halfedges, or one.
  bool is_in_triangle(Halfedge_index halfedge) const
  {
    return complex().next(complex().next(complex().next(halfedge))) == halfedge;
  }

  // Whether all triangles at a vertex are there.
  bool has_star(Vertex_index) const { return true; }

  // Whether fans with as many corners of triangles, some of which are at the border, are all that there is: every
  // corner belongs to a fan, and the halfedges are as many as the corners, and one more that leaves each border vertex.
  bool has_no_others(std::size_t number_of_corners, std::size_t number_of_border_fans) const
  {
    return number_of_corners == 3 * complex().number_of_faces()
        && number_of_corners + number_of_border_fans == 2 * complex().number_of_live_edges();
  }

  // The position in vertices(mesh), in which removed vertices do not count.
  std::size_t position(Vertex_index vertex) const
  {
    std::size_t position = 0;
    for(const Vertex_index v : Index_range(Vertex_index(0), vertex))
      position += complex().has_vertex(v) ? 1 : 0;
    return position;
  }

protected:
  // The argument has for each vertex a halfedge of a face that ends there, or anything if the derived class knows them.
  explicit Triangle_complex_base(Indexed_vector<Vertex_index, Halfedge_index> halfedges_of_vertices)
    : first_halfedges_(std::move(halfedges_of_vertices))
  {}

private:
  friend class Unchecked_complex<Complex>;

  const Complex& complex() const { return static_cast<const Complex&>(*this); }

  Indexed_vector<Vertex_index, Halfedge_index> first_halfedges_;
};

struct Halfedge
{
  Vertex_index target;
  Halfedge_index next; // in its face; no_index if it has none
};

// Arrays that a Triangle_complex is made from.
struct Halfedge_arrays
{
  Indexed_vector<Halfedge_index, Halfedge> halfedges;
  Indexed_vector<Vertex_index, Halfedge_index>
    halfedges_of_vertices; // one of a face that ends there; no_index if there is none

  // Of a part of a surface: the vertices that are inside, and have their whole stars here. Only they count as vertices.
  Indexed_vector<Vertex_index, bool> is_inside = {};
  const Indexed_vector<Vertex_index, Long_index>* positions = nullptr; // of the vertices on the surface
};

// A surface copied from a mesh of any type, or a part of one. All numbers belong to vertices and edges.
class Triangle_complex : public Triangle_complex_base<Triangle_complex>
{
public:
  Triangle_complex(Halfedge_arrays arrays, std::size_t number_of_faces)
    : Triangle_complex_base<Triangle_complex>(std::move(arrays.halfedges_of_vertices)),
      halfedges_(std::move(arrays.halfedges)),
      is_inside_(std::move(arrays.is_inside)),
      positions_(arrays.positions),
      number_of_faces_(number_of_faces)
  {}

  Index number_of_halfedges() const { return static_cast<Index>(halfedges_.size()); }
  bool has_vertex(Vertex_index vertex) const { return is_inside_.empty() || is_inside_[vertex]; }
  bool has_star(Vertex_index vertex) const { return has_vertex(vertex); }
  bool has_edge(Edge_index) const { return true; }

  Vertex_index target(Halfedge_index halfedge) const { return halfedges_[halfedge].target; }
  Halfedge_index next(Halfedge_index halfedge) const { return halfedges_[halfedge].next; }
  bool has_triangle(Halfedge_index halfedge) const { return next(halfedge) != no_index; }

  std::size_t number_of_faces() const { return number_of_faces_; }
  std::size_t number_of_live_edges() const { return halfedges_.size() / 2; }
  std::size_t position(Vertex_index vertex) const { return positions_ ? (*positions_)[vertex] : vertex.number(); }

  // The faces have been checked before, as has been that each edge has one.
  Halfedge_index halfedge_of_face_at(Vertex_index vertex) const { return first_halfedge(vertex); }
  void check_faces() const {}
  void check_edges() const {}
  bool has_no_others(std::size_t number_of_corners, std::size_t number_of_border_fans) const
  {
    const auto is_corner = [&](const Halfedge& h) { return h.next != no_index && is_inside_[h.target]; };
    return is_inside_.empty() ? Triangle_complex_base::has_no_others(number_of_corners, number_of_border_fans)
                              : std::count_if(halfedges_.begin(), halfedges_.end(), is_corner)
                                  == static_cast<std::ptrdiff_t>(number_of_corners);
  }

private:
  Indexed_vector<Halfedge_index, Halfedge>
    halfedges_;                                  // both members in one line of the cache, with the opposite halfedge
  Indexed_vector<Vertex_index, bool> is_inside_; // empty if all are
  const Indexed_vector<Vertex_index, Long_index>* positions_;
  std::size_t number_of_faces_;
};

// Throws if a face is no triangle with three vertices.
template <class FaceListGraph>
void check_faces(const FaceListGraph& mesh)
{
  std::size_t position = 0;
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    const auto h = halfedge(f, mesh);
    if(next(h, mesh) == h || next(next(h, mesh), mesh) == h || !is_triangle(h, mesh))
      throw Non_triangular_face_error(position);
    const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
    if(a == b || b == c || c == a)
      throw Degenerate_face_error(position);
    ++position;
  }
}

template <class FaceListGraph>
void check_edges(const FaceListGraph& mesh)
{
  std::size_t position = 0;
  for(const auto e : CGAL::make_range(edges(mesh)))
  {
    const auto h = halfedge(e, mesh);
    if(is_border(h, mesh) && is_border(opposite(h, mesh), mesh))
      throw Edge_without_face_error(position);
    ++position;
  }
}

// A halfedge of a face that ends where h does, the null halfedge if there is none. The turn ends at an edge that nobody
// has joined to the other ones.
template <class FaceListGraph, class HalfedgeDescriptor>
HalfedgeDescriptor find_halfedge_of_face(const FaceListGraph& mesh, HalfedgeDescriptor h)
{
  const HalfedgeDescriptor null = boost::graph_traits<FaceListGraph>::null_halfedge();
  HalfedgeDescriptor around = h;
  while(around != null && is_border(around, mesh))
  {
    const HalfedgeDescriptor second = next(around, mesh);
    around = second == null ? null : opposite(second, mesh);
    if(around == h)
      return null;
  }
  return around;
}

// A Surface_mesh, which has its halfedges in arrays already and numbers them as a Triangle_complex does: to copy them
// took longer than all else on a smooth field. Removed elements keep their numbers.
template <class Point>
class Surface_mesh_complex : public Triangle_complex_base<Surface_mesh_complex<Point>>
{
  typedef Surface_mesh<Point> Mesh;

public:
  explicit Surface_mesh_complex(const Mesh& mesh)
    : Triangle_complex_base<Surface_mesh_complex>(unset_halfedges(mesh.num_vertices())),
      mesh_(&mesh)
  {
    checked_index(mesh.num_halfedges());
  }

  Index number_of_halfedges() const { return mesh_->num_halfedges(); }
  bool has_vertex(Vertex_index v) const { return !mesh_->has_garbage() || !mesh_->is_removed(descriptor(v)); }
  bool has_edge(Edge_index e) const
  {
    return !mesh_->has_garbage() || !mesh_->is_removed(typename Mesh::Edge_index(e.number()));
  }

  Vertex_index target(Halfedge_index h) const { return Vertex_index(mesh_->target(descriptor(h))); }
  Halfedge_index next(Halfedge_index h) const { return Halfedge_index(mesh_->next(descriptor(h))); }
  bool has_triangle(Halfedge_index h) const { return !mesh_->is_border(descriptor(h)); }

  std::size_t number_of_faces() const { return mesh_->number_of_faces(); }
  std::size_t number_of_live_edges() const { return mesh_->number_of_edges(); }

  // Hides the other one, as it is known without a look at the next halfedge, which may be far away in memory.
  Halfedge_index previous(Halfedge_index h) const { return Halfedge_index(mesh_->prev(descriptor(h))); }

  // Hides the other one. Looks at the halfedge and the next one only, as the third one may be far away in memory. If that
  // is right for each halfedge of a face, as all corners are looked at, the third one leads back to the first.
  bool is_in_triangle(Halfedge_index h) const
  {
    const Halfedge_index second = next(h);
    return next(second) == previous(h) && previous(second) == h;
  }

  // Hides the other one: triangles have the numbers of faces.
  Index end_of_triangles() const { return mesh_->num_faces(); }

  // Hides the other one. All is right with a face if all that its halfedges tell agrees. In short loops without
  // branches, so that the processor has many reads before it, and waits for them at once.
  bool read_triangles(std::size_t begin, std::size_t end, Triangle_block& block) const
  {
    const bool has_garbage = mesh_->has_garbage();
    const Index last = number_of_halfedges() - 1; // Nothing has been checked yet.
    const auto at_most_last = [last](Halfedge_index h) { return h.number() < last ? h : Halfedge_index(last); };
    Index difference = 0;
    const auto compare = [&](auto u, auto v) { difference |= u.number() ^ v.number(); };
    std::size_t size = 0;
    for(const Face_index f : Index_range(Face_index(begin), Face_index(end)))
    {
      if(has_garbage && mesh_->is_removed(typename Mesh::Face_index(f.number())))
        continue;
      const Halfedge_index first = at_most_last(Halfedge_index(mesh_->halfedge(typename Mesh::Face_index(f.number()))));
      const Halfedge_index second = at_most_last(next(first)), third = at_most_last(previous(first));
      compare(face(first), f);
      compare(second, next(first));
      block.triangles[size].halfedges = {first, second, third};
      block.triangles[size++].vertices[0] = target(first);
    }
    block.size = size;
    int degenerate = 0;
    Index greatest = 0;
    for(std::size_t i = 0; i != size; ++i)
    {
      auto& [halfedges, vertices] = block.triangles[i];
      const Halfedge_index first = halfedges[0], second = halfedges[1], third = halfedges[2];
      const Vertex_index a = vertices[0], b = target(second), c = target(third);
      vertices[1] = b;
      vertices[2] = c;
      compare(next(second), third);
      compare(next(third), first);
      compare(face(second), face(third));
      compare(face(third), face(first));
      degenerate |= static_cast<int>(a == b) | static_cast<int>(b == c) | static_cast<int>(c == a);
      greatest = (std::max)({greatest, a.number(), b.number(), c.number()});
    }
    if(has_garbage)
      for(std::size_t i = 0; i != size; ++i)
        for(const Halfedge_index h : block.triangles[i].halfedges)
          difference |= has_edge(edge_of(h)) ? 0 : 1;
    return difference == 0 && degenerate == 0 && greatest < this->number_of_vertices();
  }

  Halfedge_index kept_halfedge(Vertex_index v) const { return Halfedge_index(mesh_->halfedge(descriptor(v))); }
  Halfedge_index halfedge_of_face_at(Vertex_index v) const
  {
    if(!has_vertex(v))
      return no_index;
    const auto h = find_halfedge_of_face(*mesh_, mesh_->halfedge(descriptor(v)));
    return h == mesh_->null_halfedge() ? Halfedge_index(no_index) : Halfedge_index(h);
  }
  void check_faces() const { internal::check_faces(*mesh_); }
  void check_edges() const { internal::check_edges(*mesh_); }

private:
  Face_index face(Halfedge_index h) const { return Face_index(mesh_->face(descriptor(h))); }

  static typename Mesh::Vertex_index descriptor(Vertex_index v) { return typename Mesh::Vertex_index(v.number()); }
  static typename Mesh::Halfedge_index descriptor(Halfedge_index h)
  {
    return typename Mesh::Halfedge_index(h.number());
  }

  static Indexed_vector<Vertex_index, Halfedge_index> unset_halfedges(std::size_t size)
  {
    Indexed_vector<Vertex_index, Halfedge_index> halfedges;
    halfedges.resize(checked_index(size));
    return halfedges;
  }

  const Mesh* mesh_;
};

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

// A complex that may be none, as its faces may have more than three corners and its vertices more than one fan. The fan
// of each vertex has to be set, in any order; then check() gives the complex.
template <class Complex>
class Unchecked_complex
{
public:
  explicit Unchecked_complex(Complex complex) : complex_(std::move(complex)) {}

  Index number_of_vertices() const { return complex_.number_of_vertices(); }
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
    visitor.begin(complex_.source(first));
    Halfedge_index halfedge = first;
    do
    {
      const Halfedge_index second = complex_.next(halfedge);
      if(complex_.target(halfedge) != vertex || !complex_.is_in_triangle(halfedge) || complex_.target(second) == vertex)
        return give_up(first, counts);
      ++counts.corners;
      visitor.add(complex_.target(second));
      halfedge = opposite_of(second);
    } while(halfedge != first && complex_.has_triangle(halfedge));
    if(halfedge == first)
      return true;
    if(complex_.target(halfedge) != vertex)
      return give_up(first, counts);
    for(; complex_.has_triangle(opposite_of(first)); ++counts.corners)
    {
      // Steps backwards undo those onwards. If they meet the end of these, it is a border that the other side does not
      // have.
      const Halfedge_index turned = complex_.previous(opposite_of(first));
      if(!complex_.is_in_triangle(opposite_of(first)) || !complex_.is_in_triangle(turned)
         || !complex_.has_triangle(turned) || complex_.target(turned) != vertex || complex_.source(first) == vertex
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

  void throw_non_manifold_vertex_error() const
  {
    Indexed_vector<Vertex_index, Index> unreached(number_of_vertices(), 0);
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

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SURFACE_COMPLEXES_H
