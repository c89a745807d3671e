// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Weights/mixed_voronoi_region_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The geometry of a triangle with the corners 0, 1, 2: `edges[i]` leads from corner i to corner i + 1.
struct Triangle_geometry
{
  std::array<Vector, 3> edges;
  Vector normal; // its length is twice the area
  double double_area;

  // The cotangent of the angle at corner i.
  double cotangent(int i) const { return -(edges[i] * edges[(i + 2) % 3]) / double_area; }

  // The tangent of half the angle at corner i, without cancellation.
  double half_tangent(int i) const
  {
    const double product = length(edges[i]) * length(edges[(i + 2) % 3]);
    const double cosine = -(edges[i] * edges[(i + 2) % 3]);
    return cosine > 0 ? double_area / (product + cosine) : (product - cosine) / double_area;
  }

  // The gradient of the function that is 1 at corner i and 0 at the other ones.
  Vector hat_gradient(int i) const
  {
    return (1 / double_area) * cross_product((1 / double_area) * normal, edges[(i + 1) % 3]);
  }

  int longest_edge() const
  {
    int longest = 0;
    for(int i = 1; i != 3; ++i)
      if(edges[i].squared_length() > edges[longest].squared_length())
        longest = i;
    return longest;
  }

  // Whether the triangle has an area, and one that is not so small that cotangents are beyond the range of numbers.
  bool is_proper() const
  {
    for(int i = 0; i != 3; ++i)
      if(!(double_area > 0) || !std::isfinite(cotangent(i)) || !std::isfinite(half_tangent(i))
         || !(half_tangent(i) > 0))
        return false;
    return true;
  }
};

// The geometry of the points of a triangle.
inline Triangle_geometry geometry_of_points(const Indexed_surface& surface, std::size_t triangle)
{
  const auto& v = surface.triangles()[triangle].vertices;
  Triangle_geometry geometry;
  for(int i = 0; i != 3; ++i)
    geometry.edges[i] = surface.point(v[(i + 1) % 3]) - surface.point(v[i]);
  // The product of the two short edges is the one with the least cancellation.
  const int longest = geometry.longest_edge();
  geometry.normal = cross_product(geometry.edges[(longest + 1) % 3], geometry.edges[(longest + 2) % 3]);
  geometry.double_area = length(geometry.normal);
  return geometry;
}

// A vector of unit length that is perpendicular to one of unit length.
inline Vector perpendicular(const Vector& x)
{
  int smallest = 0;
  for(int i = 1; i != 3; ++i)
    if(std::abs(x[i]) < std::abs(x[smallest]))
      smallest = i;
  const Vector axis(smallest == 0 ? 1. : 0., smallest == 1 ? 1. : 0., smallest == 2 ? 1. : 0.);
  return normalized(cross_product(x, axis));
}

// The triangle each of whose sides is longer by `added_length`, in the plane of the given one as far as that has a
// plane. Its sides have to fulfil the triangle inequality.
inline Triangle_geometry lengthened(const Triangle_geometry& given, double added_length)
{
  const int longest = given.longest_edge(), next = (longest + 1) % 3, previous = (longest + 2) % 3;
  const auto side = [&](int i) { return length(given.edges[i]) + added_length; };
  const double a = side(longest), b = (std::max)(side(next), side(previous)),
               c = (std::min)(side(next), side(previous));
  // Heron's formula as W. Kahan has it, without cancellation
  const double area = std::sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))) / 4;
  // the longest side is on the x-axis
  const double height = 2 * area / a;
  const double foot = (a + (side(previous) - side(next)) * ((side(previous) + side(next)) / a)) / 2;

  const bool has_direction = length(given.edges[longest]) > 0;
  const Vector x = has_direction ? normalized(given.edges[longest]) : Vector(1, 0, 0);
  const Vector y = given.double_area > 0 ? normalized(cross_product(given.normal, x)) : perpendicular(x);
  Triangle_geometry geometry;
  geometry.edges[longest] = a * x;
  geometry.edges[next] = (foot - a) * x + height * y;
  geometry.edges[previous] = -foot * x + -height * y;
  geometry.double_area = 2 * area;
  geometry.normal = geometry.double_area * cross_product(x, y);
  return geometry;
}

inline Triangle_geometry triangle_geometry(const Indexed_surface& surface, std::size_t triangle)
{
  const Triangle_geometry geometry = geometry_of_points(surface, triangle);
  return surface.added_length() > 0 ? lengthened(geometry, surface.added_length()) : geometry;
}

// Makes all edges longer by the least length after which any two sides of a triangle are longer than the third one by a
// margin: intrinsic mollification. See Field_report.
inline void lengthen_edges(Indexed_surface& surface, Field_report& report)
{
  constexpr double margin_of_mean = 1e-6, margin_of_longest = 1e-12;
  double sum = 0, number_of_edges = 0, longest = 0;
  // The least of the sums of two sides of a triangle less the third one; it can be negative by rounding.
  double least_slack = std::numeric_limits<double>::infinity();
  for(const Indexed_triangle& t : surface.triangles())
  {
    std::array<double, 3> sides;
    for(int i = 0; i != 3; ++i)
    {
      sides[i] = length(surface.point(t.vertices[(i + 1) % 3]) - surface.point(t.vertices[i]));
      sum += t.is_on_border[i] ? sides[i] : sides[i] / 2;
      number_of_edges += t.is_on_border[i] ? 1 : 0.5;
    }
    std::sort(sides.begin(), sides.end());
    longest = (std::max)(longest, sides[2]);
    least_slack = (std::min)(least_slack, sides[0] - (sides[2] - sides[1]));
  }
  // If all points are the same, the unit is that of the coordinates.
  const double mean = sum > 0 ? sum / number_of_edges : 1;
  const double added_length = (std::max)(margin_of_mean * mean, margin_of_longest * longest) - least_slack;
  if(!(added_length > 0))
    return;
  surface.set_added_length(added_length);
  report.mean_length = sum > 0 ? mean * surface.scale() : 0;
  report.added_length = surface.added_length() * surface.scale();
}

// Makes the edges longer if there is a triangle that is not proper.
inline Field_report make_triangles_proper(Indexed_surface& surface)
{
  Field_report report;
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    if(!geometry_of_points(surface, t).is_proper())
      ++report.number_of_bad_faces;
  if(report.number_of_bad_faces > 0)
    lengthen_edges(surface, report);
  return report;
}

// The weights of the Laplacian.
inline Weighted_graph laplacian_graph(const Indexed_surface& surface, Laplacian_weights weights)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    const auto visit_both = [&](Index u, Index v, double weight) {
      visit(Weighted_graph::Contribution{u, v, weight});
      visit(Weighted_graph::Contribution{v, u, weight});
    };
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const auto& [v, is_on_border] = surface.triangles()[t];
      const bool has_geometry = weights != Laplacian_weights::UNIFORM;
      const Triangle_geometry geometry = has_geometry ? triangle_geometry(surface, t) : Triangle_geometry();
      for(int i = 0; i != 3; ++i)
      {
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        if(weights == Laplacian_weights::UNIFORM) // w_ij = 1
          visit_both(v[i], v[next], is_on_border[i] ? 1 : 0.5);
        else if(weights == Laplacian_weights::COTANGENT) // the mean of the cotangents of the angles that face the edge
          visit_both(v[next], v[previous], geometry.cotangent(i) / 2);
        else // the tangents of half the angles at v_i on both sides of the edge, divided by its length
        {
          const double half_tangent = geometry.half_tangent(i);
          visit(Weighted_graph::Contribution{v[i], v[next], half_tangent / length(geometry.edges[i])});
          visit(Weighted_graph::Contribution{v[i], v[previous], half_tangent / length(geometry.edges[previous])});
        }
      }
    }
  });
}

// Calls solve(graph, begin, end), with the fractions of the work that are done before and after it. If its equations
// have no finite solution, and the edges have their own lengths, it makes them longer, and calls it once more.
template <class Solve>
auto solve_or_lengthen_edges(Indexed_surface& surface,
                             const Weighted_graph& graph,
                             Laplacian_weights weights,
                             Field_report& report,
                             const Solve& solve)
{
  if(weights == Laplacian_weights::UNIFORM || surface.added_length() > 0)
    return solve(graph, 0.2, 0.9);
  try
  {
    return solve(graph, 0.2, 0.8);
  }
  catch(const Linear_solver_error&)
  {}
  catch(const Non_finite_scalar_error&)
  {}
  lengthen_edges(surface, report);
  return solve(laplacian_graph(surface, weights), 0.8, 0.9);
}

// The vertex of least value of each component, the first one if there are several.
inline std::vector<Index> lowest_vertices_of_components(const Weighted_graph& graph, const std::vector<double>& values)
{
  const std::vector<Index> labels = label_components(graph);
  std::vector<Index> lowest_vertices;
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == lowest_vertices.size())
      lowest_vertices.push_back(v);
    else if(values[v] < values[lowest_vertices[labels[v]]])
      lowest_vertices[labels[v]] = v;
  return lowest_vertices;
}

// Two vertices of each component: the one farthest from its first vertex along the edges, and the one farthest from
// that; of several the first one. They are the same only in a component of a single vertex.
inline std::vector<std::pair<Index, Index>> far_apart_vertices(const Indexed_surface& surface,
                                                               const Weighted_graph& graph)
{
  typedef std::pair<double, Index> Entry;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(graph.number_of_vertices(), infinity); // between two searches
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto farthest_from = [&](Index source) {
    std::vector<Index> reached;
    const auto reach = [&](double distance, Index v) {
      if(!(distance < distances[v]))
        return;
      distances[v] = distance;
      reached.push_back(v);
      queue.emplace(distance, v);
    };
    Entry farthest(0, source);
    for(reach(0, source); !queue.empty();)
    {
      const Entry entry = queue.top();
      queue.pop();
      if(entry.first > distances[entry.second])
        continue;
      if(entry.first > farthest.first)
        farthest = entry;
      for(const auto& n : graph.neighbors(entry.second))
        if(distances[n.vertex] > entry.first)
          reach(entry.first + length(surface.point(n.vertex) - surface.point(entry.second)), n.vertex);
    }
    for(const Index v : reached)
      distances[v] = infinity;
    return farthest.second;
  };
  const std::vector<Index> labels = label_components(graph);
  std::vector<std::pair<Index, Index>> pairs;
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Index lowest = farthest_from(v), highest = farthest_from(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

inline bool is_finite(const Vector& vector)
{
  return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

// The gradients on the faces, for the points divided by surface.scale().
inline std::vector<Vector> scaled_gradients(const Indexed_surface& surface, const std::vector<double>& values)
{
  std::vector<Vector> gradients;
  gradients.reserve(surface.triangles().size());
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    const auto& v = surface.triangles()[t].vertices;
    // The hat functions add up to one, so a constant may be taken off; it makes constant fields have gradient zero.
    gradients.push_back((values[v[1]] - values[v[0]]) * geometry.hat_gradient(1)
                        + (values[v[2]] - values[v[0]]) * geometry.hat_gradient(2));
  }
  return gradients;
}

// The directions of these gradients, zero where a gradient is. Differences of values would be infinite, or lost, at the
// ends of their range: those of each face are divided by a power of two.
inline std::vector<Vector> unit_gradients(const Indexed_surface& surface, const std::vector<double>& values)
{
  std::vector<Vector> gradients;
  gradients.reserve(surface.triangles().size());
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    const auto& v = surface.triangles()[t].vertices;
    const double largest = (std::max)({std::abs(values[v[0]]), std::abs(values[v[1]]), std::abs(values[v[2]])});
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    const auto value = [&](std::size_t i) { return std::scalbn(values[v[i]], -exponent); };
    gradients.push_back(
      normalized((value(1) - value(0)) * geometry.hat_gradient(1) + (value(2) - value(0)) * geometry.hat_gradient(2)));
  }
  return gradients;
}

// The integrated divergences at the vertices.
inline std::vector<double> integrated_divergences(const Indexed_surface& surface, const std::vector<Vector>& vectors)
{
  std::vector<double> divergences(surface.number_of_vertices(), 0);
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const Triangle_geometry geometry = triangle_geometry(surface, t);
    for(int i = 0; i != 3; ++i)
    {
      const int next = (i + 1) % 3, previous = (i + 2) % 3;
      divergences[surface.triangles()[t].vertices[i]] +=
        (geometry.cotangent(previous) * (geometry.edges[i] * vectors[t])
         - geometry.cotangent(next) * (geometry.edges[previous] * vectors[t]))
        / 2;
    }
  }
  for(double& divergence : divergences)
    divergence *= surface.scale();
  return divergences;
}

// The corners of a triangle, or those of its lengthened geometry.
inline std::array<Simple_cartesian<double>::Point_3, 3> corner_points(const Indexed_surface& surface,
                                                                      std::size_t triangle)
{
  const auto& v = surface.triangles()[triangle].vertices;
  if(surface.added_length() == 0)
    return {ORIGIN + surface.point(v[0]), ORIGIN + surface.point(v[1]), ORIGIN + surface.point(v[2])};
  const Triangle_geometry geometry = triangle_geometry(surface, triangle);
  return {ORIGIN, ORIGIN + geometry.edges[0], ORIGIN + (geometry.edges[0] + geometry.edges[1])};
}

// The mixed Voronoi areas of the vertices, zero for isolated ones, for the points divided by surface.scale().
inline std::vector<double> scaled_mixed_areas(const Indexed_surface& surface)
{
  std::vector<double> areas(surface.number_of_vertices(), 0);
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
  {
    const auto points = corner_points(surface, t);
    for(int i = 0; i != 3; ++i)
      areas[surface.triangles()[t].vertices[i]] +=
        Weights::mixed_voronoi_area(points[(i + 2) % 3], points[i], points[(i + 1) % 3]);
  }
  return areas;
}

// The mean curvatures times the mixed areas, for the points divided by surface.scale(): half the lengths of the vectors
// sum_j w_ij (v_i - v_j) with cotangent weights.
inline std::vector<double> scaled_integrated_mean_curvatures(const Indexed_surface& surface,
                                                             const Weighted_graph& cotangents)
{
  std::vector<double> curvatures;
  curvatures.reserve(surface.number_of_vertices());
  for(Index v = 0; v != surface.number_of_vertices(); ++v)
  {
    Vector sum = NULL_VECTOR;
    for(const auto& n : cotangents.neighbors(v))
      sum = sum + n.weight * (surface.point(v) - surface.point(n.vertex));
    curvatures.push_back(length(sum) / 2);
  }
  return curvatures;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
