// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "commands/commands.h"
#include "input/field_input.h"
#include "output/mesh_output.h"

#include <algorithm>
#include <iostream>

namespace reeb_graph_program {
void run_field(const Field_options& options)
{
  Surface surface = read_surface(options.input);
  const Scalar_map scalar_map = add_field(options.input, surface);
  write_scalars(options.output_path, surface, scalar_map);
  std::cout << surface.number_of_vertices() << (surface.number_of_vertices() == 1 ? " value" : " values");
  if(surface.number_of_vertices() > 0)
  {
    const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
    std::cout << " from " << *lowest << " to " << *highest;
  }
  std::cout << '\n';
}

} // namespace reeb_graph_program
