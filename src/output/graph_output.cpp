// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/graph_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/svg.h>

#include <stdexcept>

namespace reeb_graph_program {
void check_graph_format(const std::filesystem::path& path)
{
  if(path.extension() != ".graphml" && path.extension() != ".dot" && path.extension() != ".svg")
    throw std::runtime_error(path.string() + ": the file name of a graph ends in .graphml, .dot, or .svg");
}

void write_graph(const std::filesystem::path& path,
                 const Graph& graph,
                 const Surface& surface,
                 const Field_label& field_label)
{
  check_graph_format(path);
  const auto vertex_index_map = get(boost::vertex_index, surface);
  write_file(path, [&](std::ostream& stream) {
    if(path.extension() == ".graphml")
      CGAL::Reeb_graph::write_graphml(stream, graph, vertex_index_map);
    else if(path.extension() == ".svg")
      CGAL::Reeb_graph::write_svg(
        stream, graph,
        CGAL::parameters::field_name(
          field_label.name,
          CGAL::parameters::field_unit(field_label.unit, CGAL::parameters::vertex_index_map(vertex_index_map))));
    else
      CGAL::Reeb_graph::write_graphviz(stream, graph, vertex_index_map);
  });
}

void write_vertex_arcs(const std::filesystem::path& path,
                       const Surface& surface,
                       const Vertex_locations& locations,
                       std::size_t number_of_nodes)
{
  write_file(path, [&](std::ostream& stream) {
    for(const Surface::Vertex_index v : surface.vertices())
    {
      const std::size_t place = locations.index(v);
      if(place < number_of_nodes)
        stream << "node " << place << '\n';
      else
        stream << "arc " << place - number_of_nodes << '\n';
    }
  });
}

} // namespace reeb_graph_program
