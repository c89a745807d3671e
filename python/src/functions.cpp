// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "functions.h"

#include "Input.h"
#include "run.h"

#include "computation/curves.h"
#include "computation/distances_along_edges.h"
#include "computation/scalar_fields.h"
#include "input/mesh_input.h"

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>

#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_python {
namespace {
// The mesh of a function that works on surfaces.
Surface make_surface(const Polygon_soup& soup, const std::string& what)
{
  Mesh mesh = make_mesh(soup, "the mesh");
  check_is_surface(mesh, what);
  return std::move(mesh.surface);
}

// The field of this name, with options as the program has them; for unit gradients, of the scalars if there are any.
Value_array field(const std::string& name,
                  const Mesh_arrays& arrays,
                  std::size_t number_of_vertices,
                  const Input_options& given_options,
                  const std::optional<Value_array>& scalars,
                  const py::object& progress,
                  std::size_t threads)
{
  Input_options options = given_options;
  options.field = name;
  options.scalars_path = scalars ? "scalars" : "";
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  const std::vector<double> given = scalars ? copy_values(*scalars) : std::vector<double>(number_of_vertices);
  std::vector<double> values;
  run(progress, threads, [&] {
    check_field_options(options);
    Mesh mesh = make_mesh(soup, "the mesh");
    const Scalar_map map = add_scalar_map(mesh.surface, "v:scalar", given);
    if(mesh.complex && name == "geodesic")
      compute_distances_along_edges(mesh, options.source_vertices, map);
    else
    {
      if(name != "height")
        check_is_surface(mesh, "the field " + name);
      Work_report report;
      compute_scalar_field(options, mesh.surface, map, report);
    }
    values.assign(map.begin(), map.end());
  });
  return array_of(values);
}

Value_array make_borders_level(const Mesh_arrays& arrays,
                               const Value_array& scalars,
                               const py::object& progress,
                               std::size_t threads)
{
  std::vector<double> values = copy_values(scalars);
  const Polygon_soup soup = copy_arrays(arrays, values.size());
  run(progress, threads, [&] {
    Surface surface = make_surface(soup, "make_borders_level()");
    const Scalar_map map = add_scalar_map(surface, "v:scalar", values);
    CGAL::Reeb_graph::make_borders_level(surface, map);
    values.assign(map.begin(), map.end());
  });
  return array_of(values);
}

struct Cut
{
  Surface surface;
  Scalar_map scalar_map;
  std::vector<Vertex_property<double>> properties;
  Cut_result result;
};

void cut_surface(Cut& cut,
                 const Polygon_soup& soup,
                 const std::vector<double>& scalars,
                 const std::vector<std::vector<double>>& arrays,
                 const Cut_options& options,
                 std::size_t largest_number_of_faces)
{
  cut.surface = make_surface(soup, "cutting");
  cut.scalar_map = add_scalar_map(cut.surface, "v:scalar", scalars);
  std::vector<Any_vertex_property> properties;
  for(const std::vector<double>& array : arrays)
  {
    cut.properties.push_back(add_scalar_map(cut.surface, "v:array" + std::to_string(cut.properties.size()), array));
    properties.emplace_back(cut.properties.back());
  }
  cut.result = cut_along_curves(cut.surface, cut.scalar_map, properties, options, [&](std::size_t number_of_faces) {
    return number_of_faces <= largest_number_of_faces;
  });
}

py::dict describe(const Cut& cut)
{
  const Surface& surface = cut.surface;
  const auto values_of = [](const Vertex_property<double>& map) {
    return array_of(std::vector<double>(map.begin(), map.end()));
  };
  Mesh mesh;
  mesh.surface = surface;
  py::list curves, arrays;
  for(const Polyline& polyline : cut.result.polylines)
    curves.append(array_of(polyline));
  for(const Vertex_property<double>& map : cut.properties)
    arrays.append(values_of(map));
  std::vector<std::size_t> patches;
  for(const Surface::Face_index f : surface.faces())
    patches.push_back(static_cast<std::size_t>(cut.result.patch_map[f]));
  py::dict result;
  result["points"] = array_of(std::vector<Point>(surface.points().begin(), surface.points().end()));
  result["triangles"] = array_of(triangles_of(mesh));
  result["patches"] = array_of(patches);
  result["curves"] = curves;
  result["scalars"] = values_of(cut.scalar_map);
  result["arrays"] = arrays;
  return result;
}

py::dict cut(Curves_type type,
             const Mesh_arrays& arrays,
             const Value_array& scalars,
             const std::vector<Value_array>& vertex_arrays,
             Cut_options options,
             std::size_t largest_number_of_faces,
             const py::object& progress,
             std::size_t threads)
{
  options.type = type;
  const std::vector<double> values = copy_values(scalars);
  const Polygon_soup soup = copy_arrays(arrays, values.size());
  std::vector<std::vector<double>> properties;
  for(const Value_array& array : vertex_arrays)
    properties.push_back(copy_values(array));
  Cut result;
  run(progress, threads, [&] {
    cut_surface(result, soup, values, properties, options,
                largest_number_of_faces > 0 ? largest_number_of_faces : std::numeric_limits<std::size_t>::max());
  });
  return describe(result);
}

} // namespace

void add_functions(py::module_& module)
{
  py::class_<Mesh_arrays>(module, "MeshArrays")
    .def(py::init<py::object, py::object, py::object, py::object>(), py::arg("triangles") = py::none(),
         py::arg("points") = py::none(), py::arg("edges") = py::none(), py::arg("tetrahedra") = py::none());
  py::class_<Input_options>(module, "FieldOptions")
    .def(py::init<>())
    .def_readwrite("weights", &Input_options::weights)
    .def_readwrite("minimum", &Input_options::lowest_vertex)
    .def_readwrite("maximum", &Input_options::highest_vertex)
    .def_readwrite("sources", &Input_options::source_vertices)
    .def_readwrite("direction", &Input_options::direction);
  py::class_<Cut_options>(module, "CutOptions")
    .def(py::init<>())
    .def_readwrite("persistence", &Cut_options::persistence)
    .def_readwrite("area", &Cut_options::area)
    .def_readwrite("cut_open", &Cut_options::is_cut_open)
    .def_readwrite("borders", &Cut_options::borders);
  py::enum_<CGAL::Reeb_graph::Borders>(module, "Borders")
    .value("level", CGAL::Reeb_graph::Borders::LEVEL)
    .value("make_level", CGAL::Reeb_graph::Borders::MAKE_LEVEL);
  py::enum_<Curves_type>(module, "Curves")
    .value("cutting_system", Curves_type::CUTTING_SYSTEM)
    .value("pants", Curves_type::PANTS)
    .value("branches", Curves_type::BRANCH);
  module.def("field", &field);
  module.def("make_borders_level", &make_borders_level);
  module.def("cut", &cut);
}

} // namespace reeb_graph_python
