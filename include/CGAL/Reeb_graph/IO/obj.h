// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_OBJ_H
#define CGAL_REEB_GRAPH_IO_OBJ_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <ostream>

namespace CGAL::Reeb_graph {

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

#endif // CGAL_REEB_GRAPH_IO_OBJ_H
