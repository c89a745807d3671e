// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_SAMPLED_GRAPH_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_SAMPLED_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Flat_field.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Edge_walk.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef Mesh::Property_map<Mesh::Vertex_index, double> Field;

// The vertex that is farthest from the centroid of the surface.
inline Mesh::Vertex_index farthest_from_centroid(const Mesh& mesh)
{
  const Point origin = mesh.point(*mesh.vertices().begin());
  Vector sum = NULL_VECTOR;
  double area = 0;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Vector a = mesh.point(mesh.source(h)) - origin, b = mesh.point(mesh.target(h)) - origin,
                 c = mesh.point(mesh.target(mesh.next(h))) - origin;
    const double size = length(cross_product(b - a, c - a));
    sum = sum + size / 3 * (a + b + c);
    area += size;
  }
  const Point centroid = area > 0 ? origin + sum / area : origin;
  const auto range = mesh.vertices();
  return *std::max_element(range.begin(), range.end(), [&](auto u, auto v) {
    return squared_distance(centroid, mesh.point(u)) < squared_distance(centroid, mesh.point(v));
  });
}

// An end of a longest way along edges: the second one that is found or, where that is the tip of a thin limb, and the first one
// the blunt end of a thick one, the first one. A front from a thin limb comes to a thick one from a side.
inline Mesh::Vertex_index find_tip(const Mesh& mesh, const Stage_progress& progress)
{
  Edge_walk walk(mesh);
  const auto go = [&](Mesh::Vertex_index from, double most) {
    walk.start(from);
    while(walk.next_distance() < most)
      walk.step();
    return walk.last();
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const auto first = go(farthest_from_centroid(mesh), infinity);
  progress(0.5);
  const auto second = go(first, infinity);
  const double size = walk.passed();
  const auto is_limb_from = [&](Mesh::Vertex_index v, double share) {
    go(v, share * size);
    return walk.width_by_distance() < Edge_walk::width_of_limb;
  };
  return is_limb_from(second, 0.1) && !is_limb_from(first, 0.1) && is_limb_from(first, 0.25) ? first : second;
}

// The apex of the border that a vertex is on, or near the opening of, or else the vertex.
inline Mesh::Vertex_index apex_beside(const Filled_component& component, Mesh::Vertex_index v)
{
  const auto point = [&](Mesh::Vertex_index u) { return component.mesh.point(u); };
  for(const Filled_border& border : component.borders)
    if(distance(point(v), point(border.apex)) < 1.5 * border.radius
       || std::find(border.rim.begin(), border.rim.end(), v) != border.rim.end())
      return border.apex;
  return v;
}

// A place far beyond an opening, as if a long tube ended there: 64 times the size of the surface, which is about 1.
inline Point far_beyond(const Mesh& mesh, Mesh::Vertex_index apex)
{
  const Point& p = mesh.point(apex);
  Vector sum = NULL_VECTOR;
  for(const auto h : CGAL::halfedges_around_target(apex, mesh))
    sum = sum + cross_product(mesh.point(mesh.source(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
  const double size = length(sum);
  return size > 0 ? p + 64 / size * sum : p;
}

// Makes the apex of a border a leaf of the graph: a maximum, or, where the surface rises from the border, a minimum.
inline void raise_apex(const Filled_component& component, const Filled_border& border, bool may_be_minimum, Field field)
{
  const Mesh& mesh = component.mesh;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, rise = 0;
  for(const auto v : border.rim)
  {
    lowest = (std::min)(lowest, field[v]);
    highest = (std::max)(highest, field[v]);
    const auto first = mesh.halfedge(v);
    auto h = first;
    do
    {
      if(mesh.source(h) != border.apex)
        rise += field[mesh.source(h)] - field[v];
      h = mesh.opposite(mesh.next(h));
    } while(h != first);
  }
  const double step = border.radius > 0 ? border.radius : 1;
  field[border.apex] = may_be_minimum && rise > 0 ? lowest - step : highest + step;
}

// Writes the distances from the tip of a component, and returns the tip. Borders are leaves, if that is wanted.
inline Mesh::Vertex_index write_distances(Filled_component& component,
                                          bool are_borders_ends,
                                          Field field,
                                          const Stage_progress& progress)
{
  Mesh& mesh = component.mesh;
  auto tip = find_tip(mesh, progress.part(0, 0.3));
  if(are_borders_ends)
    tip = apex_beside(component, tip);
  // Fronts do not take the short way across other openings, else they meet again on what is bent, at tips of nothing.
  const auto point_map = boost::make_function_property_map<Mesh::Vertex_index, Point>([&](Mesh::Vertex_index v) {
    return are_borders_ends && v != tip && component.is_apex(v) ? far_beyond(mesh, v) : mesh.point(v);
  });
  compute_geodesic_field(mesh, field, std::array<Mesh::Vertex_index, 1>{tip},
                         parameters::vertex_point_map(point_map).callback(progress.part(0.3, 1).callback()));
  for(const Filled_border& border : component.borders)
    if(are_borders_ends && border.apex != tip)
      raise_apex(component, border, false, field);
  return tip;
}

// Writes the given values, and those of the apexes: the mean of the border, if that is to be no end.
inline void write_values(const Filled_component& component, bool are_borders_ends, Field field)
{
  for(std::size_t i = 0; i != component.values.size(); ++i)
    field[Mesh::Vertex_index(static_cast<Mesh::size_type>(i))] = component.values[i];
  const auto set_mean = [&](const Filled_border& border) {
    double sum = 0;
    for(const auto v : border.rim)
      sum += field[v] / static_cast<double>(border.rim.size());
    field[border.apex] = sum;
  };
  std::for_each(component.seams.begin(), component.seams.end(), set_mean);
  for(const Filled_border& border : component.borders)
    if(are_borders_ends)
      raise_apex(component, border, true, field);
    else
      set_mean(border);
}

// A contour of an arc, by what is measured of it.
struct Contour_sample
{
  Contour_shape shape;
  Point on_surface; // one of its points
};

// The Reeb graph of a field on a component by numbers, with samples of its contours, and the place of each vertex.
class Sampled_graph
{
public:
  struct Arc
  {
    std::array<Index, 2> ends; // the lower one, and the upper one
  };

  Sampled_graph(const Mesh& mesh, Field field, const Stage_progress& progress)
    : flat_(mesh, field),
      places_(mesh.num_vertices()),
      augmentation_(mesh, flat_, compute(mesh, progress))
  {
    for(const auto arc : CGAL::make_range(edges(graph_)))
    {
      descriptors_.push_back(arc);
      arcs_.push_back({{Index(source(arc, graph_)), Index(target(arc, graph_))}});
    }
    arcs_of_nodes_.resize(num_vertices(graph_));
    for(Index arc = 0; arc != arcs_.size(); ++arc)
      for(const Index node : arcs_[arc].ends)
        arcs_of_nodes_[node].push_back(arc);
  }

  const Mesh& mesh() const { return augmentation_.mesh(); }
  Index number_of_nodes() const { return static_cast<Index>(arcs_of_nodes_.size()); }
  Index number_of_arcs() const { return static_cast<Index>(arcs_.size()); }
  const std::array<Index, 2>& ends(Index arc) const { return arcs_[arc].ends; }
  Index other_end(Index arc, Index node) const { return ends(arc)[ends(arc)[0] == node ? 1 : 0]; }
  const std::vector<Index>& arcs_of(Index node) const { return arcs_of_nodes_[node]; }
  double value(Index node) const { return graph_[node].value; }
  double value(Mesh::Vertex_index v) const { return get(flat_, v); }
  Mesh::Vertex_index vertex(Index node) const { return graph_[node].vertex; }
  const Point& point(Index node) const { return mesh().point(vertex(node)); }

  // The number of a node, or, after those, of an arc.
  Index place(Mesh::Vertex_index v) const { return places_[v.idx()]; }

  // The contour at a place of an arc, 0 at the lower end and 1 at the upper one, not quite at the ends.
  Contour_sample sample(Index arc, double t) const { return measured(contour(arc, t)); }

  // The contour of an arc right beside one of its nodes.
  Contour_sample sample_beside(Index arc, Index node) const
  {
    const bool is_lower = ends(arc)[0] == node;
    return measured(is_lower ? augmentation_.contour_above(descriptors_[arc], vertex(node))
                             : augmentation_.contour_below(descriptors_[arc], vertex(node)));
  }

  // The points of such a contour.
  std::vector<Point> contour_points(Index arc, double t) const
  {
    std::vector<Point> points;
    augmentation_.points_of_contour(contour(arc, t), std::back_inserter(points));
    return points;
  }

  // The ascending halfedges from the lower end of an arc to the contour just below the upper end, and those of this contour.
  std::array<std::vector<Mesh::Halfedge_index>, 2> chain_and_end(Index arc) const
  {
    const auto& chain = graph_[descriptors_[arc]].chain;
    return {std::vector<Mesh::Halfedge_index>(chain.begin(), chain.end()),
            augmentation_.contour_below(descriptors_[arc], vertex(ends(arc)[1])).edges};
  }

private:
  typedef Flat_field<Mesh, double> Flat;
  typedef Reeb_graph_traits<Mesh, Flat>::Graph Graph;
  typedef Augmentation<Mesh, Flat, Graph> Way_back;

  const Graph& compute(const Mesh& mesh, const Stage_progress& progress)
  {
    const auto place_map =
      boost::make_iterator_property_map(places_.begin(), get(boost::vertex_index, mesh), places_.front());
    compute_reeb_graph(mesh, flat_, graph_,
                       parameters::vertex_place_map(place_map).callback(progress.part(0, 0.9).callback()));
    return graph_;
  }

  Way_back::Contour contour(Index arc, double t) const
  {
    return augmentation_.contour(descriptors_[arc], (std::min)((std::max)(t, 1e-6), 1 - 1e-6));
  }

  Contour_sample measured(const Way_back::Contour& contour) const
  {
    points_.clear();
    augmentation_.points_of_contour(contour, std::back_inserter(points_));
    return {measure(points_), points_.front()};
  }

  Flat flat_;
  std::vector<Index> places_;
  Graph graph_;
  Way_back augmentation_;
  std::vector<boost::graph_traits<Graph>::edge_descriptor> descriptors_;
  std::vector<Arc> arcs_;
  std::vector<std::vector<Index>> arcs_of_nodes_;
  mutable std::vector<Point> points_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SAMPLED_GRAPH_H
