// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "shared.h"

#include "computation/complex_counts.h"
#include "computation/curves.h"
#include "computation/distances_along_edges.h"
#include "computation/scalar_fields.h"
#include "input/mesh_input.h"

#include <CGAL/Reeb_graph/fields/make_borders_level.h>

#include <stdexcept>
#include <variant>

namespace reeb_graph_python {
namespace {
std::vector<double> values_of(const Scalar_map& map) { return {map.begin(), map.end()}; }

Mesh make_surface(const Polygon_soup& soup, const std::string& what)
{
  Mesh mesh = make_mesh(soup, "the mesh");
  if(mesh.complex)
    throw std::runtime_error(what + " needs an oriented manifold surface; " + describe_obstacle(*mesh.complex));
  return mesh;
}

// The field of this name, with options as the program has them; for unit gradients, of the scalars if there are any. Or
// "with level borders": the scalars, changed so that they have them.
py::object field(const Mesh_arrays& arrays,
                 std::size_t number_of_vertices,
                 Input_options options,
                 const std::optional<Value_array>& scalars,
                 Run& run)
{
  options.scalars_path = scalars ? "scalars" : "";
  const Value_array* const given = scalars ? &*scalars : nullptr;
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  std::vector<double> values;
  run([&] {
    const bool is_for_complexes = options.field == "geodesic" || options.field == "height";
    Mesh mesh = is_for_complexes ? make_mesh(soup, "the mesh") : make_surface(soup, "the field " + options.field);
    const Scalar_map map = add_map(mesh.surface, "v:scalar", given);
    Work_report report;
    if(options.field == "with level borders")
      CGAL::Reeb_graph::make_borders_level(mesh.surface, map);
    else if(mesh.complex && options.field == "geodesic")
      compute_distances_along_edges(mesh, options.source_vertices, map);
    else
      compute_scalar_field(options, mesh.surface, map, report);
    values = values_of(map);
  });
  return to_object(values);
}

// Points, triangles, their patches, curves, scalars, and vertex arrays of what has been cut.
py::object cut(const Mesh_arrays& arrays,
               const Value_array& scalars,
               const std::vector<Value_array>& vertex_arrays,
               const Cut_options& options,
               std::size_t largest_number_of_faces,
               Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, scalars.size());
  Mesh mesh;
  Scalar_map map;
  std::vector<Any_vertex_property> properties;
  Cut_result result;
  run([&] {
    mesh = make_surface(soup, "cutting");
    map = add_map(mesh.surface, "v:scalar", &scalars);
    for(const Value_array& array : vertex_arrays)
      properties.emplace_back(add_map(mesh.surface, "v:array" + std::to_string(properties.size()), &array));
    result = cut_along_curves(mesh.surface, map, properties, options,
                              [&](std::size_t number_of_faces) { return number_of_faces <= largest_number_of_faces; });
  });
  std::vector<int> patches;
  for(const Surface::Face_index f : mesh.surface.faces())
    patches.push_back(result.patch_map[f]);
  std::vector<std::vector<double>> columns;
  for(const Any_vertex_property& property : properties)
    columns.push_back(values_of(std::get<Scalar_map>(property)));
  return to_object(
    std::make_tuple(points_of(mesh.surface), triangles_of(mesh), patches, result.polylines, values_of(map), columns));
}

} // namespace

void add_functions(py::module_& module)
{
  using CGAL::Reeb_graph::Borders;
  py::class_<Input_options>(module, "FieldOptions")
    .def(py::init<>())
    .def_readwrite("field", &Input_options::field)
    .def_readwrite("weights", &Input_options::weights)
    .def_readwrite("minimum", &Input_options::lowest_vertex)
    .def_readwrite("maximum", &Input_options::highest_vertex)
    .def_readwrite("sources", &Input_options::source_vertices)
    .def_readwrite("direction", &Input_options::direction);
  py::class_<Cut_options>(module, "CutOptions")
    .def(py::init<>())
    .def_readwrite("type", &Cut_options::type)
    .def_readwrite("persistence", &Cut_options::persistence)
    .def_readwrite("area", &Cut_options::area)
    .def_readwrite("cut_open", &Cut_options::is_cut_open)
    .def_readwrite("borders", &Cut_options::borders);
  py::enum_<Borders>(module, "Borders").value("make-level", Borders::MAKE_LEVEL).value("level", Borders::LEVEL);
  py::enum_<Curves_type>(module, "Curves")
    .value("cutting_system", Curves_type::CUTTING_SYSTEM)
    .value("pants", Curves_type::PANTS)
    .value("branches", Curves_type::BRANCH);
  module.def("field", &field);
  module.def("cut", &cut);
}

} // namespace reeb_graph_python
