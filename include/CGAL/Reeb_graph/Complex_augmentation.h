// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
#define CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/engine/loops_of_complexes.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/enum.h>

#include <boost/unordered_map.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A component of a level set of a complex as a graph: a point on each crossed edge, and a line in each crossed
// triangle.
struct Level_set_component
{
  typedef std::array<Index, 2> Line; // the numbers of two points

  std::vector<Edge_index> edges; // by the numbers of their points
  std::vector<Line> lines;
};

// The component on the edge `start`. Points are numbered in the order in which a search finds them, breadth first.
template <class IsBelow>
Level_set_component find_level_set_component(const Simplicial_complex& complex,
                                             Edge_index start,
                                             const IsBelow& is_below)
{
  Level_set_component component;
  boost::unordered_map<Index, Index> point_of_edge;
  const auto find_point = [&](Edge_index edge) {
    const auto inserted = point_of_edge.emplace(edge.number(), static_cast<Index>(component.edges.size()));
    if(inserted.second)
      component.edges.push_back(edge);
    return inserted.first->second;
  };
  find_point(start);
  for(Index point = 0; point != component.edges.size(); ++point)
  {
    const Edge_index edge = component.edges[point];
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      const Index other_point = find_point(beside);
      if(point < other_point) // so that each line comes once
        component.lines.push_back({point, other_point});
    });
  }
  return component;
}

struct Point_tag;
typedef Index_of<Point_tag> Point_index;

// Splits the lines of a component of a level set into polylines, which end where not exactly two lines meet. They begin
// at branch points, which more than two lines have, and at points of the border, and come in the order of their first
// points. There is only one, if the component is a closed curve or a single point.
inline void find_polylines(const Level_set_component& component,
                           std::vector<std::vector<std::size_t>>& polylines,
                           std::vector<std::size_t>& branch_points)
{
  const std::vector<Level_set_component::Line>& lines = component.lines;
  const Buckets<Point_index, std::size_t> lines_of_points(component.edges.size(), [&](const auto& visit) {
    for(std::size_t line = 0; line != lines.size(); ++line)
      for(const Index point : lines[line])
        visit(Point_index(point), line);
  });
  const auto lines_at = [&](std::size_t point) { return lines_of_points[Point_index(point)]; };
  std::vector<bool> is_used(lines.size(), false);
  const auto follow = [&](std::size_t first_point, std::size_t line) {
    polylines.push_back({first_point});
    std::vector<std::size_t>& polyline = polylines.back();
    for(;;)
    {
      is_used[line] = true;
      const std::size_t point = lines[line][lines[line][0] == polyline.back() ? 1 : 0];
      polyline.push_back(point);
      const auto lines_on = lines_at(point);
      if(point == first_point || lines_on.size() != 2)
        return;
      line = lines_on.begin()[*lines_on.begin() == line ? 1 : 0];
    }
  };
  for(std::size_t point = 0; point != component.edges.size(); ++point)
  {
    if(lines_at(point).size() > 2)
      branch_points.push_back(point);
    for(const std::size_t line : lines_at(point))
    {
      if(lines_at(point).size() != 2 && !is_used[line])
        follow(point, line);
    }
  }
  if(lines.empty())
    polylines = {{0}};
  else if(polylines.empty())
    follow(0, *lines_at(0).begin());
}

// The numbers of the cells, triangles or tetrahedra as the user lists them, at each vertex, in ascending order.
class Cell_list
{
public:
  // The cells have been checked. Their points do not matter.
  template <class Points, class CellRange>
  Cell_list(std::size_t number_of_vertices, const Points&, const CellRange& cells)
    : cells_of_vertices_(number_of_vertices, [&](const auto& visit) {
        Index number = 0;
        for(const auto& cell : cells)
        {
          for(const auto vertex : cell)
            visit(Vertex_index(static_cast<std::size_t>(vertex)), number);
          ++number;
        }
      })
  {}

  auto at_vertex(Vertex_index vertex) const { return cells_of_vertices_[vertex]; }

private:
  Buckets<Vertex_index, Index> cells_of_vertices_;
};

// Triangles, in which contours are polylines.
class Triangle_cells : public Cell_list
{
public:
  static constexpr std::size_t vertices_per_cell = 3;
  template <class Arc>
  using Contour = Soup_contour<Arc>;

  using Cell_list::Cell_list;

  auto cells(const Simplicial_complex& complex) const { return complex.triangles(); }
  const auto& vertices_of(const Simplicial_complex& complex, Triangle_index t) const { return complex.vertices_of(t); }

  // The part of the contour inside of the triangles that it crosses.
  template <class IsBelow, class Arc>
  void add_inside(const Level_set_component& component, const IsBelow&, Soup_contour<Arc>& contour) const
  {
    find_polylines(component, contour.polylines, contour.branch_points);
  }
};

// Orients triangles alike that share an edge with no third one. In each part that is connected in this way, the way in
// which most triangles are oriented before wins, of two halves that of the first one. A part that cannot be oriented
// stays as it is.
inline void orient_alike(std::vector<std::array<std::size_t, 3>>& triangles)
{
  // two ends, and twice the number of the triangle, plus one if it passes the edge from the first end
  std::vector<std::array<std::size_t, 3>> sides;
  sides.reserve(3 * triangles.size());
  for(std::size_t t = 0; t != triangles.size(); ++t)
    for(std::size_t i = 0; i != 3; ++i)
    {
      const std::size_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      sides.push_back({(std::min)(from, to), (std::max)(from, to), 2 * t + (from < to ? 1 : 0)});
    }
  std::sort(sides.begin(), sides.end());
  // each triangle as it is, and the other way round
  Disjoint_sets<Index> ways(checked_index(2 * triangles.size()));
  const auto find = [&](std::size_t way) { return ways.find(static_cast<Index>(way)); };
  for(auto side = sides.begin(), end = side; side != sides.end(); side = end)
  {
    end = std::find_if(side, sides.end(), [&](const auto& s) { return s[0] != (*side)[0] || s[1] != (*side)[1]; });
    for(std::size_t way = 0; end - side == 2 && way != 2; ++way)
      ways.link(find(side[0][2] ^ way), find(side[1][2] ^ way ^ 1));
  }
  std::vector<std::pair<std::size_t, std::size_t>> votes(2 * triangles.size()); // and one more for the first triangle
  for(std::size_t t = triangles.size(); t-- != 0;)
  {
    auto& [number, first] = votes[find(2 * t)];
    ++number;
    first = triangles.size() - t;
  }
  for(std::size_t t = 0; t != triangles.size(); ++t)
    if(votes[find(2 * t)] < votes[find(2 * t + 1)])
      std::swap(triangles[t][1], triangles[t][2]);
}

// The orientation of tetrahedra, which points of a three-dimensional kernel have.
template <class Points>
using Orientation_of = decltype(CGAL::orientation(*std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>()),
                                                  *std::begin(std::declval<const Points&>())));

// Tetrahedra with a sign each, by the way their vertices are listed: positively, as far as their points do not tell
// otherwise. One that is listed again is replaced by one of its vertices, which no level crosses. Contours are patches of
// triangles.
class Tetrahedron_cells : public Cell_list
{
  typedef std::array<Vertex_index, 4> Tetrahedron;

public:
  static constexpr std::size_t vertices_per_cell = 4;
  template <class Arc>
  using Contour = Isosurface_patch<Arc>;

  // `points` is a range of points, or the number of vertices. The tetrahedra have been checked.
  template <class Points, class TetrahedronRange>
  Tetrahedron_cells(std::size_t number_of_vertices, const Points& points, const TetrahedronRange& tetrahedra)
    : Cell_list(number_of_vertices, points, tetrahedra)
  {
    for(const auto& vertices : tetrahedra)
    {
      Tetrahedron tetrahedron;
      auto end = tetrahedron.begin();
      for(const auto v : vertices)
        *end++ = Vertex_index(static_cast<std::size_t>(v));
      if(is_negative(points, tetrahedron))
        std::swap(tetrahedron[2], tetrahedron[3]);
      tetrahedra_.push_back(tetrahedron);
    }
    replace_repeated(number_of_vertices);
  }

  const std::vector<Tetrahedron>& cells(const Simplicial_complex&) const { return tetrahedra_; }
  const Tetrahedron& vertices_of(const Simplicial_complex&, const Tetrahedron& t) const { return t; }

  // The part of the contour inside of the tetrahedra that it crosses.
  template <class IsBelow, class Arc>
  void add_inside(const Level_set_component&, const IsBelow& is_below, Isosurface_patch<Arc>& contour) const
  {
    Point_of_edge point_of_edge;
    for(std::size_t point = 0; point != contour.edges.size(); ++point)
      point_of_edge.emplace(contour.edges[point], point);
    boost::unordered_set<std::size_t> lower_vertices;
    for(const Edge& crossed : contour.edges)
    {
      if(!lower_vertices.insert(crossed.first).second)
        continue;
      for(const Index number : at_vertex(Vertex_index(crossed.first)))
      {
        Tetrahedron tetrahedron = tetrahedra_[number];
        const std::size_t number_of_lower = move_lower_to_front(tetrahedron, is_below);
        const auto lowest = std::min_element(tetrahedron.begin(), tetrahedron.begin() + number_of_lower);
        const bool is_first = lowest->number() == crossed.first; // so that the tetrahedron comes once
        if(number_of_lower != 4 && is_first && point_of_edge.count(edge(tetrahedron[0], tetrahedron[3])) != 0)
          add_triangles(tetrahedron, number_of_lower, point_of_edge, contour.triangles);
      }
    }
    orient_alike(contour.triangles);
  }

private:
  typedef std::pair<std::size_t, std::size_t> Edge;
  typedef boost::unordered_map<Edge, std::size_t> Point_of_edge;

  static Edge edge(Vertex_index lower, Vertex_index higher) { return {lower.number(), higher.number()}; }

  // Moves the vertices below the level to the front by an even permutation, which keeps the orientation, and returns
  // their number.
  template <class IsBelow>
  static std::size_t move_lower_to_front(Tetrahedron& t, const IsBelow& is_below)
  {
    std::size_t number_of_lower = 0;
    bool is_odd = false;
    for(std::size_t i = 0; i != 4; ++i)
    {
      if(!is_below(t[i]))
        continue;
      is_odd ^= i != number_of_lower;
      std::swap(t[i], t[number_of_lower++]);
    }
    if(is_odd && number_of_lower >= 2)
      std::swap(t[0], t[1]);
    else if(is_odd)
      std::swap(t[2], t[3]);
    return number_of_lower;
  }

  // In a positive tetrahedron, the first three vertices appear counterclockwise from the last one.
  static void add_triangles(const Tetrahedron& t,
                            std::size_t number_of_lower,
                            const Point_of_edge& point_of_edge,
                            std::vector<std::array<std::size_t, 3>>& triangles)
  {
    const auto point = [&](std::size_t lower, std::size_t higher) {
      return point_of_edge.at(edge(t[lower], t[higher]));
    };
    switch(number_of_lower)
    {
    case 1: triangles.push_back({point(0, 1), point(0, 2), point(0, 3)}); break;
    case 2:
      triangles.push_back({point(0, 2), point(0, 3), point(1, 3)});
      triangles.push_back({point(0, 2), point(1, 3), point(1, 2)});
      break;
    default: triangles.push_back({point(0, 3), point(1, 3), point(2, 3)});
    }
  }

  template <class Points>
  static bool is_negative(const Points& points, const Tetrahedron& t)
  {
    if constexpr(Has<Orientation_of, Points>::value)
    {
      const auto point = [&](Vertex_index v) -> decltype(auto) { return *(std::begin(points) + v.number()); };
      return CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(t[3])) == CGAL::NEGATIVE;
    }
    else
      return static_cast<void>(points), static_cast<void>(t), false;
  }

  void replace_repeated(std::size_t number_of_vertices)
  {
    std::vector<std::pair<Tetrahedron, Index>> sorted;
    for(const Vertex_index least : Index_range<Vertex_index>(number_of_vertices))
    {
      sorted.clear();
      for(const Index number : at_vertex(least))
      {
        Tetrahedron vertices = tetrahedra_[number];
        std::sort(vertices.begin(), vertices.end());
        if(vertices[0] == least)
          sorted.push_back({vertices, number});
      }
      std::sort(sorted.begin(), sorted.end());
      for(std::size_t i = 1; i < sorted.size(); ++i)
      {
        if(sorted[i - 1].first == sorted[i].first)
          tetrahedra_[sorted[i].second].fill(least);
      }
    }
  }

  std::vector<Tetrahedron> tetrahedra_;
};

// The points of a range for vertices that are numbers. It throws Attribute_count_error unless there is one for each.
template <class PointRange>
auto checked_point_map(const PointRange& points, std::size_t number_of_vertices)
{
  const auto number_of_points = static_cast<std::size_t>(std::end(points) - std::begin(points));
  if(number_of_points != number_of_vertices)
    throw Attribute_count_error("points", number_of_points, number_of_vertices);
  return boost::make_iterator_property_map(std::begin(points), boost::typed_identity_property_map<std::size_t>());
}

// A graph and the complex that its nodes and chains are on, whose vertices are numbers for the user, too. `Cells` are the
// triangles or tetrahedra as the user lists them, and know what is inside of them of a contour.
template <class ReebGraph, class Traits, class Cells>
class Graph_on_cells : public Graph_on_complex<ReebGraph, Traits, Simplicial_complex>
{
  typedef Graph_on_complex<ReebGraph, Traits, Simplicial_complex> Base;

public:
  typedef Simplicial_complex Mesh;
  typedef typename Base::node_descriptor node_descriptor;
  typedef typename Base::arc_descriptor arc_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor;
  typedef typename Cells::template Contour<arc_descriptor> Contour;
  typedef Reeb_graph::Critical_set<Contour, halfedge_descriptor, std::size_t> Critical_set;
  static constexpr std::size_t vertices_per_cell = Cells::vertices_per_cell;
  using Base::complex;

  template <class PointsOrNumber, class CellRange, class Scalars, class NamedParameters>
  Graph_on_cells(const PointsOrNumber& points,
                 const CellRange& cells,
                 const Scalars& scalars,
                 const ReebGraph& graph,
                 const Traits& traits,
                 const NamedParameters& np,
                 const Progress& progress)
    : Base(graph,
           traits,
           progress,
           [&] {
             return std::make_shared<const Flat_values<Simplicial_complex, typename Traits::Scalar>>(
               keep_flat<Simplicial_complex, typename Traits::Scalar>(flatten_cells<vertices_per_cell>(
                 Threads(), points, cells, parameters::get_parameter(np, edges_of_soup), scalars, traits)));
           }),
      cells_(this->end_of_vertices(), points, cells)
  {}

  // The edges of the complex are a mesh as far as chains need one.
  const Mesh& mesh() const { return complex(); }
  bool has_vertices() const { return this->end_of_vertices() != 0; }

  decltype(auto) cells() const { return cells_.cells(complex()); }
  template <class Cell>
  auto vertices_of(const Cell& cell) const
  {
    const auto& vertices = cells_.vertices_of(complex(), cell);
    std::array<std::size_t, vertices_per_cell> numbers;
    std::transform(vertices.begin(), vertices.end(), numbers.begin(), [](Vertex_index v) { return v.number(); });
    return numbers;
  }

  // The points of the vertices, one for each, or a map that has been made of them.
  template <class Points>
  auto point_map(const Points& points) const
  {
    static_assert(!are_named_parameters<Points>, "The points of a triangle soup, or of tetrahedra, are not given.");
    if constexpr(Has<Value_of_range, Points>::value)
      return checked_point_map(points, this->end_of_vertices());
    else
      return points;
  }

  Vertex_index source_of(const halfedge_descriptor& h) const { return this->number(h.first); }
  Vertex_index target_of(const halfedge_descriptor& h) const { return this->number(h.second); }

  // The ends of an edge that may be one of another complex.
  Vertex_index checked_source(const halfedge_descriptor& h) const { return checked(source_of(h)); }
  Vertex_index checked_target(const halfedge_descriptor& h) const { return checked(target_of(h)); }

  Edge_index find_start(const halfedge_descriptor& h) const
  {
    const Halfedge_index halfedge = complex().find_halfedge(checked_source(h), checked_target(h));
    if(halfedge == no_index)
      throw Graph_mismatch_error();
    return edge_of(halfedge);
  }

  template <class Level>
  Contour trace(arc_descriptor arc, Edge_index start, const Level& level) const
  {
    const Level_set_component component = find_level_set_component(complex(), start, level.is_below);
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    contour.edges.reserve(component.edges.size());
    for(const Edge_index edge : component.edges)
    {
      const std::size_t a = complex().lower_end(edge).number(), b = complex().higher_end(edge).number();
      const bool is_ascending = level.is_below(complex().lower_end(edge));
      contour.edges.emplace_back(is_ascending ? a : b, is_ascending ? b : a);
    }
    cells_.add_inside(component, level.is_below, contour);
    return contour;
  }

  std::vector<std::size_t> star(node_descriptor node) const
  {
    const auto cells = cells_.at_vertex(this->node_vertex(node));
    return {cells.begin(), cells.end()};
  }
  std::vector<halfedge_descriptor> border_loop(node_descriptor) const { return {}; }

private:
  static Vertex_index checked(Vertex_index vertex)
  {
    if(vertex == no_index)
      throw Graph_mismatch_error();
    return vertex;
  }

  const Cells cells_;
};

// The traits class of a soup with these values: the type of the named parameter, if that is given.
template <class Scalars, class NamedParameters>
using Soup_traits_of = Chosen_traits<Reeb_graph_soup_traits<Value_of_range<Scalars>>, NamedParameters>;

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief what `Soup_augmentation` and `Tetrahedra_augmentation` have in common.
///
/// It holds a copy of the field and of the complex, so that only the graph has to outlive it.
///
/// The contour of an arc takes time linear in the triangles at the crossed edges, or in the tetrahedra at their lower
/// vertices. It also takes time linear in the degrees of the ends of the arc and of the edge it starts from. Locating
/// vertices takes hardly longer than computing the graph again if arcs are long for the size of the cells. In solids,
/// where many contours meet few vertices, this is so for very smooth fields only. Otherwise it takes the time of
/// sorting all vertices and computing the graph with all of them: near-linear for any field.
///
/// \tparam GraphOnCells unspecified: a graph with the triangles, or the tetrahedra, that it is of
template <class GraphOnCells>
class Complex_augmentation : public Basic_augmentation<GraphOnCells>
{
  typedef Basic_augmentation<GraphOnCells> Base;

public:
  using typename Base::Graph;

  /// \brief prepares the way back from `graph` to the cells, which may go away afterwards, as the scalars may.
  ///
  /// \param points a random access range of the points of the vertices, or their number
  /// \param cells the triangles, or the tetrahedra, that the graph has been computed of
  /// \param scalars the values that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with, of which `ties`, `keep_degree_two_nodes`,
  ///        `edges` and `geom_traits` count; and `callback`, as for `compute_reeb_graph()`. To locate vertices in a
  ///        graph made by `simplify()`, the named parameter `simplification` takes the result of that
  ///
  /// \exception Graph_mismatch_error if a node is not a vertex with its value, or an arc none that `ties` gives. That
  ///            all nodes and arcs are there is checked by `locate_vertices()` only.
  ///
  /// and the exceptions of `compute_reeb_graph_of_soup()`, or of `compute_reeb_graph_of_tetrahedra()`.
  template <class PointsOrNumber,
            class Cells,
            class Scalars,
            class NamedParameters = parameters::Default_named_parameters>
  Complex_augmentation(const PointsOrNumber& points,
                       const Cells& cells,
                       const Scalars& scalars,
                       const Graph& graph,
                       const NamedParameters& np = parameters::default_values())
    : Base(internal::Progress(np), np, points, cells, scalars, graph)
  {}

#ifndef DOXYGEN_RUNNING
  // The graph is not copied.
  template <class Points, class Cells, class Scalars, class... NamedParameters>
  Complex_augmentation(const Points&, const Cells&, const Scalars&, const Graph&&, const NamedParameters&...) = delete;
#endif

  /// returns the number of vertices of the complex.
  std::size_t number_of_vertices() const { return this->on_mesh().end_of_vertices(); }
};

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a triangle soup back to it.
///
/// A contour is a graph in the triangles, see `Soup_contour`: on a surface a curve, elsewhere curves that meet where an
/// edge has more than two triangles.
///
/// It is constructed as `Complex_augmentation` is, from the points, the triangles, the scalars, the graph, and named
/// parameters.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Soup_augmentation augmentation(points, triangles, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Soup_augmentation
  : public Complex_augmentation<internal::Graph_on_cells<ReebGraph, Traits, internal::Triangle_cells>>
{
public:
  using Soup_augmentation::Complex_augmentation::Complex_augmentation;
};

#ifndef DOXYGEN_RUNNING
template <class Points, class Cells, class Scalars, class Graph, class NP = parameters::Default_named_parameters>
Soup_augmentation(const Points&, const Cells&, const Scalars&, const Graph&, const NP& = parameters::default_values())
  -> Soup_augmentation<internal::Value_of_range<Scalars>, Graph, internal::Soup_traits_of<Scalars, NP>>;
#endif

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a tetrahedral mesh back to it.
///
/// A contour is a component of an isosurface, see `Isosurface_patch`. Points of a three-dimensional kernel tell which
/// side of it is the higher one. Tetrahedra of volume zero, and all if only the number of vertices is given, are taken
/// as positively oriented, as in \cgal: the last vertex is on the side from which the others appear counterclockwise.
/// Where tetrahedra contradict their neighbors, the triangles are oriented as most of them are.
///
/// It is constructed as `Complex_augmentation` is, from the points, the tetrahedra, the scalars, the graph, and named
/// parameters.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Tetrahedra_augmentation augmentation(points, tetrahedra, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Tetrahedra_augmentation
  : public Complex_augmentation<internal::Graph_on_cells<ReebGraph, Traits, internal::Tetrahedron_cells>>
{
public:
  using Tetrahedra_augmentation::Complex_augmentation::Complex_augmentation;
};

#ifndef DOXYGEN_RUNNING
template <class Points, class Cells, class Scalars, class Graph, class NP = parameters::Default_named_parameters>
Tetrahedra_augmentation(const Points&,
                        const Cells&,
                        const Scalars&,
                        const Graph&,
                        const NP& = parameters::default_values())
  -> Tetrahedra_augmentation<internal::Value_of_range<Scalars>, Graph, internal::Soup_traits_of<Scalars, NP>>;
#endif

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
