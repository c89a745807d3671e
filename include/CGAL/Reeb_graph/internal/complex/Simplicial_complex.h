// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SIMPLICIAL_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SIMPLICIAL_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Made_on_demand.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// The triangles of a complex, each once and with ascending vertices, in lexicographic order.
struct Triangle_list
{
  Indexed_vector<Triangle_index, std::array<Vertex_index, 3>> vertices;
  Indexed_vector<Vertex_index, Index> first_triangles; // by least vertex; and the end

  Index_range<Triangle_index> with_least_vertex(Vertex_index v) const
  {
    return {Triangle_index(first_triangles[v]), Triangle_index(first_triangles[Vertex_index(v.number() + 1)])};
  }
};

// Sorts triangles that may come more than once, with their vertices in any order: first into buckets by least vertex,
// then in these, which are small. for_each_triangle(visit) calls visit(a, b, c), and is called twice.
template <class ForEachTriangle>
Triangle_list list_triangles(std::size_t number_of_vertices, const ForEachTriangle& for_each_triangle)
{
  constexpr unsigned bits = 32;
  // The two larger vertices are one number, which is sorted in one comparison.
  const auto for_each_key = [&](const auto& visit) {
    for_each_triangle([&](Vertex_index a, Vertex_index b, Vertex_index c) {
      const Index low = (std::min)(a, b).number(), high = (std::max)(a, b).number();
      const Index middle = (std::max)(low, (std::min)(high, c.number()));
      visit(Vertex_index((std::min)(low, c.number())), (std::uint64_t(middle) << bits) | (std::max)(high, c.number()));
    });
  };
  Buckets<Vertex_index, std::uint64_t> keys(number_of_vertices, for_each_key);
  Triangle_list list;
  list.vertices.reserve(keys.size());
  list.first_triangles.reset(number_of_vertices + 1);
  for(const Vertex_index v : Index_range<Vertex_index>(number_of_vertices))
  {
    list.first_triangles[v] = static_cast<Index>(list.vertices.size());
    const auto bucket = keys[v];
    if(bucket.size() > 1)
      std::sort(bucket.begin(), bucket.end());
    const auto end = std::unique(bucket.begin(), bucket.end());
    for(auto key = bucket.begin(); key != end; ++key)
      list.vertices.push_back({v, Vertex_index(*key >> bits), Vertex_index(*key & ((std::uint64_t(1) << bits) - 1))});
  }
  list.first_triangles.back() = static_cast<Index>(list.vertices.size());
  return list;
}

// The higher end of an edge, and the triangle of which the edge is the last one, no_index if it is none.
struct Higher_end
{
  Vertex_index vertex;
  Triangle_index triangle;
};

// By vertex, the higher ends of edges that the triangles with this least vertex do not have: of edges between the two
// larger vertices of triangles, and of the given edges.
template <class ForEachEdge>
Buckets<Vertex_index, Higher_end> list_higher_ends(std::size_t number_of_vertices,
                                                   const Triangle_list& triangles,
                                                   const ForEachEdge& for_each_edge)
{
  return Buckets<Vertex_index, Higher_end>(number_of_vertices, [&](const auto& visit) {
    for(const Triangle_index t : triangles.vertices.keys())
      visit(triangles.vertices[t][1], Higher_end{triangles.vertices[t][2], t});
    for_each_edge([&](Vertex_index a, Vertex_index b) {
      visit((std::min)(a, b), Higher_end{(std::max)(a, b), no_index});
    });
  });
}

// Any complex of vertices, edges and triangles, by numbers, as the stages see it: each edge may be on any number of
// triangles, or on none. The halfedge 2 e of edge e leads from the vertex of the smaller number to the other one,
// 2 e + 1 back; none of the two has a triangle of its own.
//
// What a vertex begins, its edges to larger numbers and the triangles of which it is the least, have consecutive
// numbers. The tetrahedra of a volume are not kept: the graph is that of their faces.
class Simplicial_complex
{
public:
  // Whether each edge has one or two triangles, and each vertex one fan of them. It is not known, so nobody counts on
  // it.
  static constexpr bool is_surface = false;

  // The vertices are numbered from 0. for_each_triangle(visit) calls visit(a, b, c) with the numbers of three different
  // vertices, for_each_edge(visit) calls visit(a, b), both twice over and in the same order each time. A triangle or an
  // edge may come more than once.
  template <class ForEachTriangle, class ForEachEdge>
  Simplicial_complex(std::size_t number_of_vertices,
                     const ForEachTriangle& for_each_triangle,
                     const ForEachEdge& for_each_edge)
    : first_edges_(checked_index(number_of_vertices) + 1)
  {
    Triangle_list triangles = list_triangles(number_of_vertices, for_each_triangle);
    make_edges(triangles, for_each_edge);
    vertices_of_triangles_ = std::move(triangles.vertices);
    make_lower_edges();
  }

  Index number_of_vertices() const { return static_cast<Index>(first_edges_.size()) - 1; }
  Index number_of_edges() const { return static_cast<Index>(higher_ends_.size()); }
  Index number_of_halfedges() const { return 2 * number_of_edges(); }
  Index number_of_triangles() const { return static_cast<Index>(vertices_of_triangles_.size()); }
  Index_range<Vertex_index> vertices() const { return Index_range<Vertex_index>(number_of_vertices()); }
  Index_range<Edge_index> edges() const { return Index_range<Edge_index>(number_of_edges()); }
  Index_range<Triangle_index> triangles() const { return Index_range<Triangle_index>(number_of_triangles()); }

  bool has_vertex(Vertex_index) const { return true; }
  bool has_edge(Edge_index) const { return true; }

  // The ends of an edge by their numbers, which say nothing of the field.
  Vertex_index lower_end(Edge_index edge) const { return lower_ends_[edge]; }
  Vertex_index higher_end(Edge_index edge) const { return higher_ends_[edge]; }
  Vertex_index target(Halfedge_index halfedge) const
  {
    return halfedge.number() % 2 == 0 ? higher_ends_[edge_of(halfedge)] : lower_ends_[edge_of(halfedge)];
  }
  Vertex_index source(Halfedge_index halfedge) const { return target(opposite_of(halfedge)); }

  // Levels cross edges with triangles and those without in the same way.
  bool is_on_triangle(Edge_index) const { return true; }
  Halfedge_index halfedge_of_triangle(Edge_index edge) const { return even_halfedge(edge); }

  // The edges from a vertex to vertices with larger numbers.
  Index_range<Edge_index> edges_from(Vertex_index vertex) const
  {
    return {Edge_index(first_edges_[vertex]), Edge_index(first_edges_[Vertex_index(vertex.number() + 1)])};
  }

  // The vertices of a triangle by ascending number, and its edges: that of the first two, of the outer two, and of the
  // last two vertices.
  const std::array<Vertex_index, 3>& vertices_of(Triangle_index triangle) const
  {
    return vertices_of_triangles_[triangle];
  }
  const std::array<Edge_index, 3>& edges_of(Triangle_index triangle) const { return edges_of_triangles_[triangle]; }

  // The triangles at an edge. They are listed when they are asked for first.
  typedef Buckets<Edge_index, Triangle_index>::Bucket Triangles;
  Triangles triangles_of(Edge_index edge) const
  {
    return triangles_of_edges_([this] { return list_triangles_of_edges(); })[edge];
  }

  // Whether the edge is on exactly two triangles, as inside of a surface.
  bool has_two_triangles(Edge_index edge) const { return numbers_of_triangles_[edge] == 2; }

  // Calls visit(neighbor, halfedge), where `halfedge` is one of the edge to `neighbor`, for the edges at `vertex`,
  // until a call returns true.
  template <class Visit>
  void visit_edges_around(Vertex_index vertex, const Visit& visit) const
  {
    for(const Edge_index edge : lower_edges_[vertex])
    {
      if(visit(lower_ends_[edge], even_halfedge(edge)))
        return;
    }
    for(const Edge_index edge : edges_from(vertex))
    {
      if(visit(higher_ends_[edge], opposite_of(even_halfedge(edge))))
        return;
    }
  }

  // Calls visit(neighbor, halfedge) in the same way for each edge at `vertex`. The halfedges end there.
  template <class Visit>
  void for_each_edge_around(Vertex_index vertex, const Visit& visit) const
  {
    visit_edges_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
      visit(neighbor, halfedge);
      return false;
    });
  }

  // A halfedge of the edge of two vertices, from the first one to the second one, no_index if there is none.
  Halfedge_index find_halfedge(Vertex_index source, Vertex_index target) const
  {
    const Vertex_index low = (std::min)(source, target), high = (std::max)(source, target);
    const auto edges = lower_edges_[high]; // which are sorted by their lower ends
    const auto edge =
      std::partition_point(edges.begin(), edges.end(), [&](Edge_index e) { return lower_ends_[e] < low; });
    if(edge == edges.end() || lower_ends_[*edge] != low)
      return no_index;
    return low == source ? even_halfedge(*edge) : opposite_of(even_halfedge(*edge));
  }

  bool is_on_border_edge(Halfedge_index halfedge) const { return !has_two_triangles(edge_of(halfedge)); }

  // Whether the vertex has edges, and one of them is not on exactly two triangles.
  bool is_on_border(Vertex_index vertex) const
  {
    bool result = false;
    visit_edges_around(vertex,
                       [&](Vertex_index, Halfedge_index halfedge) { return result = is_on_border_edge(halfedge); });
    return result;
  }

  // The number of a vertex among those of the user.
  std::size_t position(Vertex_index vertex) const { return vertex.number(); }

private:
  static constexpr unsigned char several = 3;

  // Numbers the edges by their lower ends. An edge is known by its higher end among those of one lower end.
  template <class ForEachEdge>
  void make_edges(const Triangle_list& triangles, const ForEachEdge& for_each_edge)
  {
    const Buckets<Vertex_index, Higher_end> more_ends =
      list_higher_ends(number_of_vertices(), triangles, for_each_edge);
    edges_of_triangles_.reset(triangles.vertices.size());
    lower_ends_.reserve(triangles.vertices.size() * 3 / 2 + 16);
    higher_ends_.reserve(lower_ends_.capacity());
    numbers_of_triangles_.reserve(lower_ends_.capacity());
    Indexed_vector<Vertex_index, Index> edge_to(number_of_vertices(), no_index);
    for(const Vertex_index v : vertices())
    {
      const Index first = checked_index(2 * higher_ends_.size()) / 2;
      first_edges_[v] = first;
      const auto edge_of_end = [&](Vertex_index end) {
        if(edge_to[end] == no_index || edge_to[end] < first)
        {
          edge_to[end] = number_of_edges();
          lower_ends_.push_back(v);
          higher_ends_.push_back(end);
          numbers_of_triangles_.push_back(0);
        }
        return Edge_index(edge_to[end]);
      };
      const auto add_triangle = [&](Triangle_index triangle, std::size_t place, Vertex_index end) {
        const Edge_index edge = edge_of_end(end);
        edges_of_triangles_[triangle][place] = edge;
        unsigned char& number = numbers_of_triangles_[edge];
        number = static_cast<unsigned char>(number == several ? several : number + 1);
      };
      for(const Triangle_index t : triangles.with_least_vertex(v))
      {
        add_triangle(t, 0, triangles.vertices[t][1]);
        add_triangle(t, 1, triangles.vertices[t][2]);
      }
      for(const Higher_end& end : more_ends[v])
      {
        if(end.triangle == no_index)
          edge_of_end(end.vertex);
        else
          add_triangle(end.triangle, 2, end.vertex);
      }
    }
    first_edges_.back() = checked_index(2 * higher_ends_.size()) / 2;
  }

  void make_lower_edges()
  {
    const auto for_each_end = [&](const auto& visit) {
      for(const Edge_index edge : edges())
        visit(higher_ends_[edge], edge);
    };
    lower_edges_ = Buckets<Vertex_index, Edge_index>(number_of_vertices(), for_each_end);
  }

  Buckets<Edge_index, Triangle_index> list_triangles_of_edges() const
  {
    const auto for_each_edge_of_triangle = [&](const auto& visit) {
      for(const Triangle_index triangle : triangles())
        for(const Edge_index edge : edges_of(triangle))
          visit(edge, triangle);
    };
    return Buckets<Edge_index, Triangle_index>(number_of_edges(), for_each_edge_of_triangle);
  }

  Indexed_vector<Vertex_index, Index> first_edges_; // with smaller numbers; and the end
  Indexed_vector<Edge_index, Vertex_index> lower_ends_;
  Indexed_vector<Edge_index, Vertex_index> higher_ends_;
  Indexed_vector<Triangle_index, std::array<Vertex_index, 3>> vertices_of_triangles_;
  Indexed_vector<Triangle_index, std::array<Edge_index, 3>> edges_of_triangles_;
  Buckets<Vertex_index, Edge_index> lower_edges_;                  // to vertices with smaller numbers
  Indexed_vector<Edge_index, unsigned char> numbers_of_triangles_; // or `several` if there are more
  Made_on_demand<Buckets<Edge_index, Triangle_index>> triangles_of_edges_;
};

// The number of vertices, given as such or by a range of points.
template <class PointsOrNumber>
std::size_t count_vertices(const PointsOrNumber& points)
{
  if constexpr(std::is_integral_v<PointsOrNumber>)
    return static_cast<std::size_t>(points);
  else
    return static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
}

template <class Range>
using Value_of_range = typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::value_type;

// The indices of an edge, which may be given as a pair.
template <class Simplex>
const Simplex& as_range(const Simplex& simplex)
{
  return simplex;
}

template <class First, class Second>
std::array<First, 2> as_range(const std::pair<First, Second>& edge)
{
  return {edge.first, edge.second};
}

// How a range of indices fails to be a simplex of `size` vertices.
enum class Simplex_fault
{
  NONE,
  SIZE,
  INDEX,
  REPETITION
};

// Reads a range of `size` different indices of vertices. Negative numbers are no indices.
template <std::size_t size, class Simplex>
Simplex_fault read_simplex(const Simplex& simplex,
                           std::size_t number_of_vertices,
                           std::array<Vertex_index, size>& result)
{
  std::size_t n = 0;
  bool are_vertices = true;
  const auto& indices = as_range(simplex);
  for(const auto index : indices)
  {
    if(n == size)
      return Simplex_fault::SIZE;
    const bool is_vertex = !(index < 0) && static_cast<std::size_t>(index) < number_of_vertices;
    are_vertices &= is_vertex;
    result[n++] = Vertex_index(static_cast<std::size_t>(index));
  }
  if(n != size)
    return Simplex_fault::SIZE;
  if(!are_vertices)
    return Simplex_fault::INDEX;
  for(std::size_t i = 0; i != size; ++i)
    for(std::size_t j = 0; j != i; ++j)
      if(result[i] == result[j])
        return Simplex_fault::REPETITION;
  return Simplex_fault::NONE;
}

// Calls visit(vertices) for each simplex of a range, and throw_error(position, fault) for the first that is none.
template <std::size_t size, class Simplices, class ThrowError, class Visit>
void for_each_simplex(const Simplices& simplices,
                      std::size_t number_of_vertices,
                      const ThrowError& throw_error,
                      const Visit& visit)
{
  std::size_t position = 0;
  std::array<Vertex_index, size> vertices = {};
  for(const auto& simplex : simplices)
  {
    const Simplex_fault fault = read_simplex<size>(simplex, number_of_vertices, vertices);
    if(fault != Simplex_fault::NONE)
      throw_error(position, fault);
    visit(vertices);
    ++position;
  }
}

// Throws the error of a range of indices that is no triangle, or no tetrahedron.
template <std::size_t vertices_per_cell>
[[noreturn]] void throw_cell_error(std::size_t cell, Simplex_fault fault)
{
  if(fault == Simplex_fault::INDEX)
    throw Vertex_out_of_range_error(vertices_per_cell == 3 ? "face" : "tetrahedron", cell);
  if(vertices_per_cell == 4)
    throw Non_tetrahedral_cell_error(cell);
  if(fault == Simplex_fault::SIZE)
    throw Non_triangular_face_error(cell);
  throw Degenerate_face_error(cell);
}

// The complex of triangles, or of the faces of tetrahedra, and of edges, which are pairs of indices.
template <std::size_t vertices_per_cell, class Cells, class Edges>
Simplicial_complex read_cells(std::size_t number_of_vertices, const Cells& cells, const Edges& edges)
{
  checked_index(number_of_vertices);
  const auto for_each_triangle = [&](const auto& visit) {
    for_each_simplex<vertices_per_cell>(cells, number_of_vertices, throw_cell_error<vertices_per_cell>,
                                        [&](const auto& v) {
                                          visit(v[0], v[1], v[2]);
                                          if constexpr(vertices_per_cell == 4)
                                          {
                                            visit(v[0], v[1], v[3]);
                                            visit(v[0], v[2], v[3]);
                                            visit(v[1], v[2], v[3]);
                                          }
                                        });
  };
  const auto for_each_edge = [&](const auto& visit) {
    const auto throw_error = [](std::size_t edge, Simplex_fault fault) {
      if(fault == Simplex_fault::INDEX)
        throw Vertex_out_of_range_error("edge", edge);
      throw Degenerate_edge_error(edge);
    };
    for_each_simplex<2>(edges, number_of_vertices, throw_error, [&](const auto& v) { visit(v[0], v[1]); });
  };
  return Simplicial_complex(number_of_vertices, for_each_triangle, for_each_edge);
}

} // namespace CGAL::Reeb_graph::internal

namespace boost {

// A soup of triangles has no other mesh than the complex, which stands where a mesh is asked for.
template <>
struct graph_traits<CGAL::Reeb_graph::internal::Simplicial_complex>
{
  typedef std::size_t vertex_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor; // source and target
};

} // namespace boost

namespace CGAL::Reeb_graph::internal {

template <>
struct Descriptors<Simplicial_complex, false>
{
  typedef boost::graph_traits<Simplicial_complex>::vertex_descriptor vertex_descriptor, face_descriptor;
  typedef boost::graph_traits<Simplicial_complex>::halfedge_descriptor halfedge_descriptor;
};

inline std::size_t source(const boost::graph_traits<Simplicial_complex>::halfedge_descriptor& h,
                          const Simplicial_complex&)
{
  return h.first;
}
inline std::size_t target(const boost::graph_traits<Simplicial_complex>::halfedge_descriptor& h,
                          const Simplicial_complex&)
{
  return h.second;
}
inline std::size_t num_vertices(const Simplicial_complex& complex) { return complex.number_of_vertices(); }

// The type of a scalar map in the traits class of a soup.
template <class Scalar>
using Soup_scalars = boost::iterator_property_map<const Scalar*, boost::typed_identity_property_map<std::size_t>>;

template <>
class Vertex_list<Simplicial_complex>
{
public:
  typedef std::size_t vertex_descriptor;

  explicit Vertex_list(std::size_t size) : size_(size) {}

  std::size_t size() const { return size_; }
  bool contains(Vertex_index) const { return true; }
  vertex_descriptor operator[](Vertex_index v) const { return v.number(); }
  std::size_t position(Vertex_index v) const { return v.number(); }

private:
  std::size_t size_;
};

template <>
class Halfedge_list<Simplicial_complex>
{
public:
  typedef boost::graph_traits<Simplicial_complex>::halfedge_descriptor halfedge_descriptor;

  halfedge_descriptor operator()(const Simplicial_complex& complex, Halfedge_index halfedge) const
  {
    return {complex.source(halfedge).number(), complex.target(halfedge).number()};
  }
};

template <>
struct Complex_of<Simplicial_complex>
{
  typedef Simplicial_complex type;
};

// A soup, or the faces of tetrahedra, with its field by numbers.
template <class Scalar>
using Flat_soup = Complex_with_field<Simplicial_complex, Simplicial_complex, Scalar>;

// The values of the vertices, one for each in a random access range.
template <class Scalars, class Traits>
Keyed_field<typename Traits::Scalar> read_scalars(const Threads& threads,
                                                  std::size_t number_of_vertices,
                                                  const Scalars& scalars,
                                                  const Traits& traits)
{
  const std::size_t number_of_scalars = static_cast<std::size_t>(std::end(scalars) - std::begin(scalars));
  if(number_of_scalars != number_of_vertices)
    throw Scalar_count_error(number_of_scalars, number_of_vertices);
  const auto map =
    boost::make_iterator_property_map(std::begin(scalars), boost::typed_identity_property_map<std::size_t>());
  return read_field(threads, Vertex_list<Simplicial_complex>(number_of_vertices), map, traits);
}

// The complex of triangles or of tetrahedra, by their number of vertices, and of the edges of a named parameter, with
// its field by numbers. The field is checked before the complex.
template <std::size_t vertices_per_cell,
          class PointsOrNumber,
          class Cells,
          class EdgesParameter,
          class Scalars,
          class Traits>
Flat_soup<typename Traits::Scalar> flatten_cells(const Threads& threads,
                                                 const PointsOrNumber& points,
                                                 const Cells& cells,
                                                 const EdgesParameter& edges_parameter,
                                                 const Scalars& scalars,
                                                 const Traits& traits)
{
  auto edges = parameters::choose_parameter<std::array<std::array<std::size_t, 2>, 0>>(edges_parameter);
  const std::size_t size = count_vertices(points);
  auto field = read_scalars(threads, size, scalars, traits);
  const auto number_of = [=](std::size_t v) { return v < size ? Vertex_index(v) : Vertex_index(no_index); };
  return {read_cells<vertices_per_cell>(size, cells, unwrap_reference(edges)),
          {Vertex_list<Simplicial_complex>(size), {}, number_of},
          std::move(field)};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_SIMPLICIAL_COMPLEX_H
