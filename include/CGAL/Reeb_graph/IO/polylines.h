// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_POLYLINES_H
#define CGAL_REEB_GRAPH_IO_POLYLINES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/internal/way_back/arc_polylines.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphIO
///
/// \brief writes polylines in the format `.polylines.txt` of \cgal: one per line, the number of its points and their
/// coordinates, with as many digits as it takes to read the same numbers back.
///
/// \tparam PolylineRange a range of ranges of points
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param polylines the polylines; the last point of a closed one is the first one again
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
template <class PolylineRange>
void write_polylines(const internal::Output& output, const PolylineRange& polylines)
{
  output([&](std::ostream& out) {
    const internal::Classic_locale classic_locale(out);
    const auto precision = out.precision(std::numeric_limits<double>::max_digits10);
    for(const auto& polyline : polylines)
    {
      out << std::distance(std::begin(polyline), std::end(polyline));
      for(const auto& point : polyline)
        out << ' ' << point;
      out << '\n';
    }
    out.precision(precision);
  });
}

/// \ingroup PkgReebGraphIO
///
/// \brief returns the points of the polylines of a contour. The first one of a closed polyline is repeated at its end. On
/// a mesh there is one polyline; in tetrahedra there is none, unless the contour is a single point.
///
/// \param augmentation an `Augmentation`, `Soup_augmentation`, or `Tetrahedra_augmentation`
/// \param contour a contour that it has returned
/// \param points the points of the vertices, as `Basic_augmentation::points_of_contour()` takes them
///
/// \reebGraphComplexity
template <class Augmentation, class Points = parameters::Default_named_parameters>
auto polylines_of_contour(const Augmentation& augmentation,
                          const typename Augmentation::Contour& contour,
                          const Points& points = parameters::default_values())
{
  const auto points_of_contour = internal::points_of(augmentation, contour, augmentation.on_mesh().point_map(points));
  std::vector<std::decay_t<decltype(points_of_contour)>> polylines;
  contour.for_each_polyline([&](const std::vector<std::size_t>& numbers) {
    polylines.emplace_back();
    for(const std::size_t i : numbers)
      polylines.back().push_back(points_of_contour[i]);
  });
  return polylines;
}

/// \ingroup PkgReebGraphIO
///
/// \brief returns the points of a curve of a refined mesh, of which the first one is repeated at the end if the curve
/// is closed.
///
/// \param mesh the refined mesh
/// \param curve a `Reeb_graph::Curve` with at least one halfedge
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", of which `vertex_point_map` counts
///
/// \reebGraphComplexity
template <class FaceGraph, class Curve, class NamedParameters = parameters::Default_named_parameters>
auto polyline_of_curve(const FaceGraph& mesh,
                       const Curve& curve,
                       const NamedParameters& np = parameters::default_values())
{
  const auto point_map = internal::choose_point_map(mesh, np);
  std::vector<internal::Point_of_mesh<FaceGraph, NamedParameters>> polyline;
  polyline.reserve(curve.halfedges.size() + 1);
  for(const auto h : curve.halfedges)
    polyline.push_back(get(point_map, source(h, mesh)));
  polyline.push_back(get(point_map, target(curve.halfedges.back(), mesh)));
  return polyline;
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in space in the format OBJ of Wavefront: the nodes as points `p`, and the arcs as lines
/// `l`, each in a group of its own, `node_0` and so on, `arc_0` and so on.
///
/// The points of the nodes come first, in their order; numbers have all digits.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
template <class Graph, class Embedding>
void write_obj(const internal::Output& output, const Graph& graph, const Embedding& embedding)
{
  output([&](std::ostream& out) {
    internal::Text_output text(out);
    const auto write_point = [&](const auto& point) {
      text << 'v';
      for(const double coordinate : internal::coordinates_of(point))
        text << ' ' << coordinate;
      text << '\n';
    };
    for(const auto& point : embedding.node_points)
      write_point(point);
    for(const auto& polyline : embedding.arc_polylines)
      for(std::size_t j = 1; j + 1 < polyline.size(); ++j)
        write_point(polyline[j]);
    for(const auto node : CGAL::make_range(vertices(graph)))
      text << "g node_" << node << "\np " << node + 1 << '\n';
    std::size_t arc_number = 0, last_point = num_vertices(graph);
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      text << "g arc_" << arc_number << "\nl " << source(arc, graph) + 1;
      for(std::size_t j = 1; j + 1 < embedding.arc_polylines[arc_number].size(); ++j)
        text << ' ' << ++last_point;
      text << ' ' << target(arc, graph) + 1 << '\n';
      ++arc_number;
    }
    text.flush();
  });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_POLYLINES_H
