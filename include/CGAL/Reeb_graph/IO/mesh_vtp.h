// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_MESH_VTP_H
#define CGAL_REEB_GRAPH_IO_MESH_VTP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/IO/attributes.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/io/Vtp_document.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

inline void write_attributes(Vtp_document& document, const std::vector<Attribute>& attributes)
{
  for(const Attribute& attribute : attributes)
    std::visit([&](const auto& numbers) { document.write_array(attribute.name, numbers); }, attribute.numbers);
}

// Writes the colors of vertices or faces, if there is a map of them.
template <class Range, class ColorMap>
void write_colors(Vtp_document& document, const Range& range, const ColorMap& color_map)
{
  if constexpr(is_given<ColorMap>)
  {
    std::vector<std::uint8_t> colors;
    for(const auto thing : range)
    {
      const CGAL::IO::Color color = get(color_map, thing);
      colors.insert(colors.end(), {color.red(), color.green(), color.blue()});
    }
    document.write_array("color", colors, 3);
  }
}

inline std::string name_of_first(const std::vector<Attribute>& attributes)
{
  return attributes.empty() ? "" : attributes.front().name;
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes a mesh with numbers of its vertices and faces as an XML file of VTK, `.vtp`, which ParaView, PyVista
/// and other programs open.
///
/// The points are in the order of `vertices(mesh)`, the cells in that of `faces(mesh)`.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param mesh the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_attributes}
///     \cgalParamDescription{numbers of the vertices: the field, or the arcs that they belong to}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::vertex_attributes()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_attributes}
///     \cgalParamDescription{numbers of the faces, such as their patches}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::face_attributes()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_color_map}
///     \cgalParamDescription{colors of the vertices, written as an array `color` of red, green and blue}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type and `CGAL::IO::Color` as
///                    value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_color_map}
///     \cgalParamDescription{the colors of the faces}
///     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptors as key type and `CGAL::IO::Color` as
///                    value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Attribute_count_error if an attribute has not one number for each vertex, or face
template <class FaceListGraph, class NamedParameters = parameters::Default_named_parameters>
void write_mesh_vtp(std::ostream& out,
                    const FaceListGraph& mesh,
                    const NamedParameters& np = parameters::default_values())
{
  const internal::Classic_locale classic_locale(out);
  using parameters::get_parameter;
  const auto point_map = internal::choose_point_map(mesh, np);
  const auto index_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::vector<double> coordinates;
  std::size_t number_of_vertices = 0;
  for(const auto v : CGAL::make_range(vertices(mesh)))
  {
    put(index_map, v, number_of_vertices++);
    internal::add_coordinates(get(point_map, v), coordinates);
  }
  internal::Vtp_document::Cells polygons;
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      polygons.add_point(get(index_map, v));
    polygons.end_cell();
  }
  const std::vector<Attribute> vertex_attributes =
    internal::checked_attributes(get_parameter(np, internal::vertex_attributes), number_of_vertices);
  const std::vector<Attribute> face_attributes =
    internal::checked_attributes(get_parameter(np, internal::face_attributes), polygons.ends.size());

  internal::Vtp_document document(out, number_of_vertices, {}, {}, polygons);
  document.write_section("Points", "", [&] { document.write_array("Points", coordinates, 3); });
  document.write_section("PointData", internal::name_of_first(vertex_attributes), [&] {
    internal::write_attributes(document, vertex_attributes);
    internal::write_colors(document, CGAL::make_range(vertices(mesh)),
                           get_parameter(np, internal_np::vertex_color_map));
  });
  document.write_section("CellData", internal::name_of_first(face_attributes), [&] {
    internal::write_attributes(document, face_attributes);
    internal::write_colors(document, CGAL::make_range(faces(mesh)), get_parameter(np, internal_np::face_color_map));
  });
  document.finish();
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a mesh with numbers to a file `.vtp`. The stream is as above.
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each vertex, or face
template <class FaceListGraph, class NamedParameters = parameters::Default_named_parameters>
void write_mesh_vtp(const std::string& filename,
                    const FaceListGraph& mesh,
                    const NamedParameters& np = parameters::default_values())
{
  // before the file is opened, which empties it
  internal::checked_attributes(parameters::get_parameter(np, internal::vertex_attributes),
                               CGAL::make_range(vertices(mesh)).size());
  internal::checked_attributes(parameters::get_parameter(np, internal::face_attributes),
                               CGAL::make_range(faces(mesh)).size());
  internal::write_file(filename, [&](std::ostream& out) { Reeb_graph::write_mesh_vtp(out, mesh, np); });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_MESH_VTP_H
