// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Input.h"

#include "computation/complex_counts.h"
#include "input/mesh_input.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace reeb_graph_python {
Scalar_map add_scalar_map(Surface& surface, const std::string& name, const std::vector<double>& values)
{
  Scalar_map map = surface.add_property_map<Surface::Vertex_index, double>(name).first;
  if(!values.empty())
    std::copy(values.begin(), values.end(), &map[Surface::Vertex_index(0)]);
  return map;
}

void make_input(Input& input, const Polygon_soup& soup, const std::vector<double>& scalars, std::vector<double> values)
{
  input.mesh = make_mesh(soup, "the mesh");
  input.scalar_map = add_scalar_map(input.mesh.surface, "v:scalar", scalars);
  input.value_map = input.scalar_map;
  if(values.empty())
    return;
  input.value_map = add_scalar_map(input.mesh.surface, "v:value", values);
  for(std::size_t v = 0; v < scalars.size(); ++v)
  {
    const auto rank = static_cast<std::size_t>(scalars[v]);
    if(rank >= input.levels.size())
      input.levels.resize(rank + 1);
    input.levels[rank] = values[v];
  }
}

void check_is_surface(const Mesh& mesh, const std::string& what)
{
  if(mesh.complex)
    throw std::invalid_argument(what + " needs an oriented manifold surface; " + describe_obstacle(*mesh.complex));
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh)
{
  if(mesh.complex)
    return mesh.complex->triangles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(mesh.surface.number_of_faces());
  for(const Surface::Face_index f : mesh.surface.faces())
  {
    const Surface::Halfedge_index h = mesh.surface.halfedge(f);
    triangles.push_back({mesh.surface.source(h), mesh.surface.target(h), mesh.surface.target(mesh.surface.next(h))});
  }
  return triangles;
}

} // namespace reeb_graph_python
