// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <cstddef>
#include <string>
#include <vector>

// Curve skeletons, by distances and by a given field. On noise, contours at branches are as long as the surface is large.
namespace growth {
namespace {
typedef Surface_with_field Subject;

std::vector<Function<Subject>> functions()
{
  return {{"extract_curve_skeleton",
           [](const Subject& s) {
             CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
             CGAL::Reeb_graph::extract_curve_skeleton(s.mesh, skeleton);
             return num_vertices(skeleton);
           }},
          {"extract_curve_skeleton, of a field", [](const Subject& s) {
             CGAL::Reeb_graph::Curve_skeleton<Mesh> skeleton;
             CGAL::Reeb_graph::extract_curve_skeleton(s.mesh, skeleton, CGAL::parameters::scalar_map(s.field));
             return num_vertices(skeleton);
           }}};
}
} // namespace

void measure_skeletons(Table& table)
{
  const std::size_t n = 3000, number_of_inputs = all_inputs(100).size();
  for(std::size_t i = 0; i < number_of_inputs; ++i)
  {
    const std::string name = all_inputs(100)[i].name;
    if(name.find("noise") != std::string::npos)
      continue; // Its contours are as long as the surface is large.
    const auto subjects = at_three_sizes<Subject>(n, [i](std::size_t size) { return all_inputs(size)[i]; });
    for(const Function<Subject>& function : functions())
      table.measure(name, subjects, function);
  }
}
} // namespace growth
