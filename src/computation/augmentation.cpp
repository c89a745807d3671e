// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/augmentation.h"

#include "base/progress_bar.h"
#include "computation/Mesh_graph_of.h"
#include "computation/analysis.h"

#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/compute_reeb_graph.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The graph of a surface.
class Surface_kind
{
public:
  typedef reeb_graph_program::Graph Graph;
  typedef reeb_graph_program::Augmentation Augmentation;

  Surface_kind(const Mesh& mesh, Scalar_map scalar_map) : surface_(mesh.surface), scalar_map_(scalar_map) {}

  auto named_parameters(const Graph_options& options) const { return reeb_graph_program::named_parameters(options); }

  template <class NamedParameters>
  Graph compute(const NamedParameters& np) const
  {
    Graph graph;
    CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(surface_, scalar_map_, graph, np);
    return graph;
  }

  template <class NamedParameters>
  std::unique_ptr<const Augmentation> augment(const Graph& graph, const NamedParameters& np) const
  {
    return std::make_unique<const Augmentation>(surface_, scalar_map_, graph, np);
  }

  const Graph& on_surface(const Graph& graph, std::optional<Graph>&) const { return graph; }
  std::size_t end_of_vertices() const { return surface_.number_of_vertices() + surface_.number_of_removed_vertices(); }
  auto vertex_numbers() const { return get(boost::vertex_index, surface_); }

  template <class NamedParameters>
  auto embed(const Augmentation& augmentation, const NamedParameters& np) const
  {
    return CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(augmentation, np);
  }

  template <class MakeAugmentation>
  std::vector<Arc_column> measure_arcs(const Graph& graph,
                                       const std::vector<std::size_t>& places,
                                       const MakeAugmentation&) const
  {
    return {length_column(CGAL::Reeb_graph::arc_lengths(surface_, scalar_map_, graph)),
            size_column("area", CGAL::Reeb_graph::arc_areas(surface_, graph, Vertex_places{places})),
            vertices_column(surface_.vertices(), places, num_vertices(graph), num_edges(graph)),
            {{"mean_value", CGAL::Reeb_graph::arc_mean_values(surface_, scalar_map_, graph, Vertex_places{places})},
             Arc_joining::MEAN_BY_AREA,
             Arc_unit::VALUE,
             false}};
  }

  std::pair<std::size_t, std::size_t> ends(Surface::Halfedge_index h) const
  {
    return {surface_.source(h), surface_.target(h)};
  }

  Contour contour(const Augmentation& augmentation, const Augmentation::Contour& contour) const
  {
    Contour result;
    result.is_closed = contour.is_closed;
    std::vector<std::size_t>& line = result.polylines.emplace_back();
    for(const Surface::Halfedge_index h : contour.halfedges)
    {
      line.push_back(line.size());
      result.edges.push_back({surface_.source(h), surface_.target(h)});
    }
    if(contour.is_closed)
      line.push_back(0);
    augmentation.points_of_contour(contour, std::back_inserter(result.points));
    return result;
  }

  template <class CriticalSet>
  std::vector<std::size_t> border_loop(const CriticalSet& set) const
  {
    std::vector<std::size_t> vertices;
    for(const Surface::Halfedge_index h : set.border_loop)
      vertices.push_back(surface_.target(h));
    return vertices;
  }

  Scalar_map scalar_map() const { return scalar_map_; }

  Nearest_place nearest_place(const Point& point) const
  {
    Nearest_place place(point);
    for(const Surface::Face_index f : surface_.faces())
    {
      std::array<Point, 3> points;
      std::array<double, 3> values;
      std::size_t i = 0;
      for(const Surface::Vertex_index v : surface_.vertices_around_face(surface_.halfedge(f)))
      {
        points[i] = surface_.point(v);
        values[i++] = scalar_map_[v];
      }
      place.add_triangle(points, values);
    }
    return place;
  }

private:
  const Surface& surface_;
  const Scalar_map scalar_map_;
};

} // namespace

std::unique_ptr<Mesh_graph> compute_mesh_graph(const Mesh& mesh,
                                               Scalar_map scalar_map,
                                               const Graph_options& options,
                                               const Simplification_options& simplification,
                                               double threshold,
                                               Report& report)
{
  if(mesh.complex)
    return compute_complex_graph(mesh, scalar_map, options, simplification, threshold, report);
  return std::make_unique<Mesh_graph_of<Surface_kind>>(mesh, scalar_map, options, simplification, threshold, report);
}

} // namespace reeb_graph_program
