// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/graph_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace reeb_graph_program {
namespace {
namespace fs = std::filesystem;

struct Graph_format
{
  std::string ending;
  bool is_in_space;
  bool has_attributes;
};

const std::vector<Graph_format>& graph_formats()
{
  static const std::vector<Graph_format> formats = {
    {".graphml", false, true}, {".dot", false, false},          {".svg", false, false}, {".vtp", true, true},
    {".obj", true, false},     {".polylines.txt", true, false}, {".json", true, true},  {".csv", true, true}};
  return formats;
}

const Graph_format& format_of(const fs::path& path)
{
  const std::vector<Graph_format>& formats = graph_formats();
  std::vector<std::string> endings;
  for(const Graph_format& format : formats)
    endings.push_back(format.ending);
  const std::string ending = ending_of(path, "a graph", endings);
  return formats[std::find(endings.begin(), endings.end(), ending) - endings.begin()];
}

// X.csv stands for X.nodes.csv and X.arcs.csv.
fs::path table_path(const fs::path& path, const std::string& name)
{
  return fs::path(path).replace_extension("." + name + ".csv");
}

} // namespace

void check_graph_format(const fs::path& path) { format_of(path); }

bool is_format_in_space(const fs::path& path) { return format_of(path).is_in_space; }

bool has_arc_attributes(const fs::path& path) { return format_of(path).has_attributes; }

std::vector<fs::path> graph_files(const fs::path& path)
{
  if(path.extension() == ".csv")
    return {table_path(path, "nodes"), table_path(path, "arcs")};
  return {path};
}

void write_graph(const fs::path& path,
                 const Graph& graph,
                 const Field_label& field_label,
                 const Vertex_numbers& vertex_numbers,
                 const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes)
{
  const std::string ending = format_of(path).ending;
  write_file(path, [&](std::ostream& stream) {
    if(ending == ".graphml")
      CGAL::Reeb_graph::write_graphml(stream, graph, vertex_numbers, CGAL::parameters::arc_attributes(arc_attributes));
    else if(ending == ".svg")
      CGAL::Reeb_graph::write_svg(
        stream, graph,
        CGAL::parameters::field_name(field_label.name).field_unit(field_label.unit).vertex_index_map(vertex_numbers));
    else
      CGAL::Reeb_graph::write_graphviz(stream, graph, vertex_numbers);
  });
}

void write_graph_in_space(const fs::path& path,
                          const Graph& graph,
                          const Embedding& embedding,
                          const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                          const std::function<void(std::ostream&)>& write_json)
{
  const Vertex_numbers vertex_numbers;
  const auto attributes = CGAL::parameters::arc_attributes(arc_attributes);
  const std::string ending = format_of(path).ending;
  if(ending == ".csv")
  {
    Output_group tables;
    write_file(table_path(path, "nodes"), [&](std::ostream& stream) {
      CGAL::Reeb_graph::write_nodes_csv(stream, graph, embedding, vertex_numbers);
    });
    write_file(table_path(path, "arcs"),
               [&](std::ostream& stream) { CGAL::Reeb_graph::write_arcs_csv(stream, graph, embedding, attributes); });
    return tables.put_in_place();
  }
  write_file(path, [&](std::ostream& stream) {
    if(ending == ".vtp")
      CGAL::Reeb_graph::write_vtp(stream, graph, embedding, vertex_numbers, attributes);
    else if(ending == ".obj")
      CGAL::Reeb_graph::write_obj(stream, graph, embedding);
    else if(ending == ".json")
      write_json(stream);
    else
      CGAL::Reeb_graph::write_polylines(stream, embedding.arc_polylines);
  });
}

void note_lost_nodes(const fs::path& path, const Graph& graph, std::vector<std::string>& notes)
{
  const auto nodes = CGAL::make_range(vertices(graph));
  const auto number = std::count_if(nodes.begin(), nodes.end(),
                                    [&](auto node) { return in_degree(node, graph) + out_degree(node, graph) == 0; });
  if(number > 0 && format_of(path).ending == ".polylines.txt")
    notes.push_back(path.string()
                    + ": nodes without arcs are left out, as they have no line: " + std::to_string(number));
}

void note_lost_unit(const std::string& unit, bool is_shown, std::vector<std::string>& notes)
{
  if(!unit.empty() && !is_shown)
    notes.emplace_back("the unit is left out: --html and drawings of graphs, .svg, show it");
}

void write_vertex_arcs(const std::filesystem::path& path,
                       const std::vector<std::size_t>& places,
                       std::size_t number_of_nodes)
{
  write_file(path, [&](std::ostream& stream) {
    if(is_npy(path))
      return write_npy(stream, std::vector<std::int64_t>(places.begin(), places.end()));
    CGAL::Reeb_graph::internal::Text_output text(stream);
    for(const std::size_t place : places)
      if(place < number_of_nodes)
        text << "node " << place << '\n';
      else
        text << "arc " << place - number_of_nodes << '\n';
    text.flush();
  });
}

} // namespace reeb_graph_program
