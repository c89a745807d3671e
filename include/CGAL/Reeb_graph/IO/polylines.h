// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_POLYLINES_H
#define CGAL_REEB_GRAPH_IO_POLYLINES_H

#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
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
/// \brief returns the points of a contour, of which the first one is repeated at the end if the contour is closed.
///
/// The first argument is the mesh.
///
/// \param augmentation the `Augmentation` that has returned the contour
/// \param contour the contour
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", of which `vertex_point_map` counts
///
/// \reebGraphComplexity
template <class FaceListGraph, class Augmentation, class NamedParameters = parameters::Default_named_parameters>
auto polyline_of_contour(const FaceListGraph&,
                         const Augmentation& augmentation,
                         const typename Augmentation::Contour& contour,
                         const NamedParameters& np = parameters::default_values())
{
  std::vector<internal::Point_of_mesh<FaceListGraph, NamedParameters>> polyline;
  polyline.reserve(contour.halfedges.size() + 1);
  augmentation.points_of_contour(contour, std::back_inserter(polyline), np);
  if(contour.is_closed)
    polyline.push_back(polyline[0]);
  return polyline;
}

/// \ingroup PkgReebGraphIO
///
/// \brief returns the points of the polylines of a contour in a triangle soup.
///
/// \param contour a `Soup_contour`
/// \param vertex_points the points of the vertices of the soup, a random access range
///
/// \reebGraphComplexity
template <class SoupContour, class PointRange>
auto polylines_of_contour(const SoupContour& contour, const PointRange& vertex_points)
{
  typedef typename std::iterator_traits<decltype(std::begin(vertex_points))>::value_type Point;
  const auto point_of = [&](std::size_t v) -> decltype(auto) { return *(std::begin(vertex_points) + v); };
  std::vector<std::vector<Point>> polylines;
  for(const auto& polyline : contour.polylines)
  {
    polylines.emplace_back();
    for(const auto i : polyline)
      polylines.back().push_back(internal::point_of_crossing(contour, i, point_of));
  }
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

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_POLYLINES_H
