// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "handle_samples.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/handles/remove_handles.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// Handles and tunnels. The loops are the output.
namespace growth {
namespace {
namespace parameters = CGAL::parameters;
typedef Surface_with_field Subject;

Function<Subject> loops(const std::string& name, bool are_shortened)
{
  return {name, [are_shortened](const Subject& s) {
            const auto found = CGAL::Reeb_graph::handle_and_tunnel_loops(
              s.mesh, s.field, parameters::shorten_loops(are_shortened).check_self_intersections(false));
            std::size_t length = 0;
            for(const auto& loop : found.loops())
              length += loop.halfedges.size();
            return length;
          }};
}

std::vector<Function<Subject>> functions()
{
  return {loops("handle_and_tunnel_loops, long", false),
          loops("handle_and_tunnel_loops", true),
          {"remove_handles",
           [](const Subject& s) {
             Mesh mesh = s.mesh;
             CGAL::Reeb_graph::remove_handles(mesh, std::numeric_limits<double>::infinity(),
                                              parameters::number_of_handles(3).ignore_self_intersections(true));
             return mesh.number_of_faces() - s.mesh.number_of_faces();
           },
           2.5}}; // the loops of all handles are looked for, which are no output here
}
// What lies near to a gyroid in a ball, less a face: without inside, loops are made shorter than those of a tree by little else
// than a choice of what they are sums of.
Input open_sponge(std::size_t number_of_vertices)
{
  const double radius = 4 * std::cbrt(static_cast<double>(number_of_vertices) / 3000);
  Input input = {"open sponge", handle_samples::gyroid(radius, 0.5), {}};
  input.soup.triangles.pop_back();
  input.values = tilted_height(input.soup);
  return input;
}
} // namespace

void measure_handles(Table& table)
{
  const std::size_t n = 3000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const std::string name = all_inputs(100)[i].name;
    if(name.find("noise") != std::string::npos)
      continue; // The field has an influence on persistences only.
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    for(const Function<Subject>& function : functions())
      table.measure(name, subjects, function);
  }
  Function<Subject> of_sponge = loops("handle_and_tunnel_loops", true);
  of_sponge.largest_exponent = 2; // Numbers of all pairs of loops are kept.
  table.measure_memory("open sponge", at_three_sizes<Subject>(3000, open_sponge), of_sponge);
}
} // namespace growth
