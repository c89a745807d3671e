// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/field_input.h"

#include "computation/scalar_fields.h"
#include "input/mesh_input.h"
#include "input/scalar_input.h"

#include <vector>

namespace reeb_graph_program {
Surface read_surface(const Input_options& options)
{
  check_field_options(options);
  return read_surface(options.mesh_path, options.are_faces_triangulated);
}

Scalar_map add_field(const Input_options& options, Surface& surface)
{
  const Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  if(!options.scalars_path.empty())
  {
    const std::vector<double> scalars = read_scalars(options.scalars_path, surface.number_of_vertices());
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = scalars[v];
  }
  if(options.field == "x" || options.field == "y" || options.field == "z")
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = surface.point(v)[options.field[0] - 'x'];
  else if(!options.field.empty())
    compute_scalar_field(options, surface, scalar_map);
  return scalar_map;
}

} // namespace reeb_graph_program
