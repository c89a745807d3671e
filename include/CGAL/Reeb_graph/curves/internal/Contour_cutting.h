// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CUTTING_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CUTTING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Joins edges to curves: the longest paths through vertices with two of the edges, in the order of their first edges,
// those that end before those that do not.
template <class Mesh>
class Edge_tracing
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

public:
  explicit Edge_tracing(Mesh& mesh)
    : mesh_(mesh),
      is_left_(get(dynamic_edge_property_t<bool>(), mesh)),
      number_of_edges_(get(dynamic_vertex_property_t<std::size_t>(), mesh))
  {
    for(const edge_descriptor e : edges(mesh))
      put(is_left_, e, false);
  }

  std::vector<std::vector<halfedge_descriptor>> operator()(const std::vector<edge_descriptor>& given)
  {
    for(const int step : {0, 1})
      for(const edge_descriptor e : given)
        for(const vertex_descriptor v : {source(e, mesh_), target(e, mesh_)})
          put(number_of_edges_, v, step == 0 ? 0 : get(number_of_edges_, v) + 1);
    for(const edge_descriptor e : given)
      put(is_left_, e, true);
    std::vector<std::vector<halfedge_descriptor>> paths;
    for(const bool is_closed : {false, true})
      for(const edge_descriptor e : given)
        for(const halfedge_descriptor h : {halfedge(e, mesh_), opposite(halfedge(e, mesh_), mesh_)})
          if(get(is_left_, e) && (is_closed || get(number_of_edges_, source(h, mesh_)) != 2))
            paths.push_back(path_from(h));
    return paths;
  }

private:
  // The path that begins with a halfedge.
  std::vector<halfedge_descriptor> path_from(halfedge_descriptor first)
  {
    std::vector<halfedge_descriptor> path = {first};
    put(is_left_, edge(first, mesh_), false);
    for(bool is_longer = true; is_longer;)
    {
      is_longer = false;
      const vertex_descriptor v = target(path.back(), mesh_);
      if(get(number_of_edges_, v) != 2)
        break;
      for(const halfedge_descriptor h : halfedges_around_source(v, mesh_))
        if(get(is_left_, edge(h, mesh_)))
        {
          put(is_left_, edge(h, mesh_), false);
          path.push_back(h);
          is_longer = true;
          break;
        }
    }
    return path;
  }

  Mesh& mesh_;
  typename boost::property_map<Mesh, dynamic_edge_property_t<bool>>::type is_left_; // on no path yet
  typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type number_of_edges_;
};

// The curve of halfedges of a mesh that has not been cut open.
template <class Mesh, class VertexPointMap, class HalfedgeDescriptor>
Curve<HalfedgeDescriptor> make_curve(const Mesh& mesh,
                                     const VertexPointMap& vertex_point_map,
                                     std::vector<HalfedgeDescriptor> halfedges,
                                     double value)
{
  Curve<HalfedgeDescriptor> curve;
  curve.value = value;
  curve.is_closed = source(halfedges.front(), mesh) == target(halfedges.back(), mesh);
  for(const HalfedgeDescriptor h : halfedges)
  {
    curve.lower_halfedges.push_back(opposite(h, mesh));
    curve.length += distance_between(get(vertex_point_map, target(h, mesh)), get(vertex_point_map, source(h, mesh)));
  }
  curve.halfedges = std::move(halfedges);
  return curve;
}

// A contour that is to become a path of edges. It is the same for all levels between the highest lower end and the
// lowest upper end of its halfedges.
template <class HalfedgeDescriptor>
struct Contour_to_cut
{
  std::vector<HalfedgeDescriptor> halfedges; // ascending, one for each crossed edge; the higher side is on the left
  bool is_closed = false;
  double value = 0;
  Long_index lower_rank = 0; // rank of the highest lower end
  bool is_falling = false;   // whether larger values are lower there, in another order than that of numbers

  friend bool operator<(const Contour_to_cut& a, const Contour_to_cut& b)
  {
    const auto height = [](const Contour_to_cut& contour) {
      return contour.is_falling ? -contour.value : contour.value;
    };
    return std::make_pair(a.lower_rank, height(a)) < std::make_pair(b.lower_rank, height(b));
  }
};

// The numbers of the contours in ascending order.
template <class HalfedgeDescriptor>
std::vector<std::size_t> sorted_contours(const std::vector<Contour_to_cut<HalfedgeDescriptor>>& contours)
{
  std::vector<std::size_t> order(contours.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return contours[a] < contours[b]; });
  return order;
}

// Refines a mesh so that contours become paths of edges. Two contours that cross one edge are either the same, or one
// is above the other all along, so that an order of all of them is one along each edge, too.
template <class RankedMesh>
class Contour_cutting
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename RankedMesh::face_descriptor face_descriptor;
  typedef Contour_to_cut<halfedge_descriptor> Contour;

  struct Crossing
  {
    std::size_t contour, number; // the crossings of all contours are numbered in their order
  };

public:
  Contour_cutting(const RankedMesh& ranked, const std::vector<Contour>& contours)
    : ranked_(ranked),
      mesh_(ranked.mesh()),
      contours_(contours),
      crossing_map_(get(dynamic_vertex_property_t<std::size_t>(), mesh_))
  {}

  std::vector<Curve<halfedge_descriptor>> operator()(const Stage_progress& progress)
  {
    for(const vertex_descriptor v : vertices(mesh_))
      put(crossing_map_, v, 0);
    sort_crossings();
    collect_faces();
    const std::size_t number_of_edges = crossed_edges_.size(), number_of_faces = crossed_faces_.size();
    for(std::size_t edge = 0; edge != number_of_edges; ++edge)
    {
      progress.part(0.1, 0.4).report_step(edge, number_of_edges);
      split_edge(edge);
    }
    for(std::size_t i = 0; i != number_of_faces; ++i)
    {
      progress.part(0.4, 0.9).report_step(i, number_of_faces);
      split_face(crossed_faces_[i]);
    }
    return make_curves();
  }

private:
  // Numbers the edges as they are met, and sorts the crossings of each one by level, as it takes the contours in ascending
  // order.
  void sort_crossings()
  {
    const auto edge_number_map = get(dynamic_edge_property_t<std::size_t>(), mesh_);
    for(const auto e : edges(mesh_))
      put(edge_number_map, e, 0);
    first_numbers_.assign(1, 0);
    for(const Contour& contour : contours_)
    {
      first_numbers_.push_back(first_numbers_.back() + contour.halfedges.size());
      for(const halfedge_descriptor h : contour.halfedges)
      {
        if(get(edge_number_map, edge(h, mesh_)) != 0)
          continue;
        crossed_edges_.push_back(h);
        put(edge_number_map, edge(h, mesh_), crossed_edges_.size());
      }
    }
    const std::vector<std::size_t> order = sorted_contours(contours_);
    crossings_ = Buckets<Edge_index, Crossing>(crossed_edges_.size(), [&](const auto& visit) {
      for(const std::size_t contour : order)
      {
        std::size_t number = first_numbers_[contour];
        for(const halfedge_descriptor h : contours_[contour].halfedges)
          visit(Edge_index(get(edge_number_map, edge(h, mesh_)) - 1), Crossing{contour, number++});
      }
    });
  }

  void collect_faces()
  {
    boost::unordered_set<face_descriptor> listed;
    for(const halfedge_descriptor h : crossed_edges_)
      for(const halfedge_descriptor side : {h, opposite(h, mesh_)})
        if(!is_border(side, mesh_) && listed.insert(face(side, mesh_)).second)
          crossed_faces_.push_back(face(side, mesh_));
  }

  void split_edge(std::size_t edge)
  {
    const halfedge_descriptor h = crossed_edges_[edge];
    const vertex_descriptor u = source(h, mesh_), w = target(h, mesh_);
    const auto crossings = crossings_[Edge_index(edge)];
    place_crossings(crossings, u, w);
    for(std::size_t i = 0; i != fractions_.size(); ++i)
    {
      const halfedge_descriptor first = ranked_.split_edge(h, u, w, fractions_[i]);
      put(crossing_map_, target(first, mesh_), crossings.begin()[i].number + 1);
    }
  }

  // Places the crossings where the values of their contours are on the edge, but keeps them apart from each other and
  // from the ends.
  template <class Crossings>
  void place_crossings(const Crossings& crossings, vertex_descriptor u, vertex_descriptor w)
  {
    const std::size_t size = crossings.size();
    const double number = static_cast<double>(size), step = 0.4 / (number + 1), margin = 0.1 / (number + 1);
    fractions_.resize(size);
    for(std::size_t i = 0; i != size; ++i)
    {
      const double value = contours_[crossings.begin()[i].contour].value;
      const double lowest = i == 0 ? margin : fractions_[i - 1] + step;
      fractions_[i] = (std::max)(lowest, ranked_.crossing_fraction(u, w, value));
    }
    double highest = 1 - margin;
    for(std::size_t i = size; i-- != 0; highest = fractions_[i] - step)
      fractions_[i] = (std::min)(fractions_[i], highest);
  }

  void split_face(face_descriptor f)
  {
    const auto is_point = [&](halfedge_descriptor h) { return get(crossing_map_, target(h, mesh_)) != 0; };
    const auto ends = ranked_.ends_of(f, [&](halfedge_descriptor h) { return !is_point(h); });
    ranked_.split_triangle(ends, is_point, [&](halfedge_descriptor segment) { set_path(segment); });
  }

  void set_path(halfedge_descriptor segment)
  {
    path_.resize(crossings_.size());
    path_[get(crossing_map_, source(segment, mesh_)) - 1] = segment;
  }

  std::vector<Curve<halfedge_descriptor>> make_curves() const
  {
    std::vector<Curve<halfedge_descriptor>> curves;
    for(std::size_t contour = 0; contour != contours_.size(); ++contour)
    {
      const auto first = path_.begin() + first_numbers_[contour];
      const auto last = first + contours_[contour].halfedges.size() - (contours_[contour].is_closed ? 0 : 1);
      curves.push_back(make_curve(mesh_, ranked_.vertex_point_map(), std::vector<halfedge_descriptor>(first, last),
                                  contours_[contour].value));
    }
    return curves;
  }

  const RankedMesh& ranked_;
  Mesh& mesh_;
  const std::vector<Contour>& contours_;
  // The number of its crossing for each new vertex, plus one.
  typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type crossing_map_;
  std::vector<std::size_t> first_numbers_; // number of the first crossing, by contour, and one more
  std::vector<halfedge_descriptor> crossed_edges_;
  Buckets<Edge_index, Crossing> crossings_; // ascending on each edge
  std::vector<face_descriptor> crossed_faces_;
  std::vector<halfedge_descriptor> path_; // halfedge of the curve that leaves a crossing, by crossing
  std::vector<double> fractions_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CUTTING_H
