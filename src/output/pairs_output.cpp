// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/pairs_output.h"

#include "output/output_file.h"

#include <CGAL/Reeb_graph/internal/io/text.h>

#include <ostream>

namespace reeb_graph_program {
namespace {
using CGAL::Reeb_graph::internal::Text_output;

void write_csv(Text_output& text,
               const Graph& graph,
               const std::vector<Persistence_pair>& pairs,
               const Vertex_numbers& vertex_numbers)
{
  text << "kind,lower_vertex,upper_vertex,lower_value,upper_value,persistence\n";
  for(const Persistence_pair& pair : pairs)
  {
    const auto &lower = graph[pair.lower_node], &upper = graph[pair.upper_node];
    text << to_string(pair.kind) << ',' << get(vertex_numbers, lower.vertex) << ',' << get(vertex_numbers, upper.vertex)
         << ',' << lower.value << ',' << upper.value << ',' << CGAL::Reeb_graph::persistence(graph, pair) << '\n';
  }
}

// What lives in sublevel sets has dimension 0 and is born below; relative classes and loops have dimension 1 and are
// born above.
void write_pers(Text_output& text, const Graph& graph, const std::vector<Persistence_pair>& pairs)
{
  typedef CGAL::Reeb_graph::Persistence_pair_kind Kind;
  text << "# dimension birth death: 0 minimum saddle, 1 maximum saddle, 0 minimum maximum, 1 of a loop\n";
  for(const Persistence_pair& pair : pairs)
  {
    const double lower = graph[pair.lower_node].value, upper = graph[pair.upper_node].value;
    if(pair.kind == Kind::MINIMUM_SADDLE || pair.kind == Kind::MINIMUM_MAXIMUM)
      text << "0 " << lower << ' ' << upper << '\n';
    else
      text << "1 " << upper << ' ' << lower << '\n';
  }
}

} // namespace

void check_pairs_format(const std::filesystem::path& path) { ending_of(path, "pairs", {".csv", ".pers"}); }

void write_pairs(const std::filesystem::path& path,
                 const Graph& graph,
                 const std::vector<Persistence_pair>& pairs,
                 const Vertex_numbers& vertex_numbers)
{
  check_pairs_format(path);
  write_file(path, [&](std::ostream& stream) {
    Text_output text(stream);
    if(path.extension() != ".pers")
      write_csv(text, graph, pairs, vertex_numbers);
    else
      write_pers(text, graph, pairs);
    text.flush();
  });
}

} // namespace reeb_graph_program
