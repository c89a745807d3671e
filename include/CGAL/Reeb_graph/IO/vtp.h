// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_VTP_H
#define CGAL_REEB_GRAPH_IO_VTP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/io/Vtp_document.h>
#include <CGAL/Reeb_graph/internal/io/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

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
/// \brief writes a Reeb graph in space as an XML file of VTK, `.vtp`, which ParaView, PyVista and other programs open.
///
/// Points and cells have numbers, to color them by. Where a number makes no sense it is -1, or NaN in floating point.
///
/// - The points are first the nodes, then the inner points of the polylines of the arcs, arc by arc. Their arrays are
///   `value`, and `node`, `kind` and `vertex` of nodes, and `arc` of inner points.
/// - The cells are first a vertex for each node, then a polyline for each arc, from its lower to its upper node. Their
///   arrays are `node`, `kind` and `vertex` of nodes, `arc` of arcs, and `lower_value` and `upper_value`; and with
///   names of their own, the `arc_attributes`.
///
/// The numbers of `kind` are those of `Node_kind`: 0 isolated, 1 minimum, 2 saddle, 3 maximum, 4 degree two.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{arc_attributes}
///     \cgalParamDescription{numbers of the arcs that are written, too, such as what `arc_persistences()`,
///                           `arc_lengths()` and `arc_areas()` return}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph,
          class Embedding,
          class VertexIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_vtp(const internal::Output& output,
               const Graph& graph,
               const Embedding& embedding,
               VertexIndexMap vertex_index_map,
               const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Graph_and_vertex_map<Graph, VertexIndexMap>::value)
  {
    using internal::padded;
    const std::size_t number_of_nodes = num_vertices(graph), number_of_arcs = num_edges(graph);
    const std::vector<Attribute> attributes =
      internal::checked_attributes(parameters::get_parameter(np, internal::arc_attributes), number_of_arcs);
    const internal::Vtp_graph<Graph, Embedding> points(graph, embedding);
    const std::size_t number_of_inner_points = points.arc_of_point.size();
    std::vector<std::int64_t> node_numbers, arc_numbers, kinds, vertex_numbers;
    std::vector<double> lower_values = embedding.node_values, upper_values = lower_values;
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      node_numbers.push_back(static_cast<std::int64_t>(node));
      kinds.push_back(static_cast<std::int64_t>(graph[node].kind));
      vertex_numbers.push_back(static_cast<std::int64_t>(get(vertex_index_map, graph[node].vertex)));
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      arc_numbers.push_back(static_cast<std::int64_t>(arc_numbers.size()));
      lower_values.push_back(embedding.node_values[source(arc, graph)]);
      upper_values.push_back(embedding.node_values[target(arc, graph)]);
    }

    output([&](std::ostream& out) {
      const internal::Classic_locale classic_locale(out);
      internal::Vtp_document document(out, points.values.size(), points.nodes, points.arcs, {});
      document.write_section("Points", "", [&] { document.write_array("Points", points.coordinates, 3); });
      document.write_section("PointData", "value", [&] {
        document.write_array("value", points.values);
        document.write_array("node", padded(0, node_numbers, number_of_inner_points));
        document.write_array("kind", padded(0, kinds, number_of_inner_points));
        document.write_array("vertex", padded(0, vertex_numbers, number_of_inner_points));
        document.write_array("arc", padded(number_of_nodes, points.arc_of_point, 0));
      });
      document.write_section("CellData", "arc", [&] {
        document.write_array("node", padded(0, node_numbers, number_of_arcs));
        document.write_array("kind", padded(0, kinds, number_of_arcs));
        document.write_array("vertex", padded(0, vertex_numbers, number_of_arcs));
        document.write_array("arc", padded(number_of_nodes, arc_numbers, 0));
        document.write_array("lower_value", lower_values);
        document.write_array("upper_value", upper_values);
        for(const Attribute& attribute : attributes)
          std::visit(
            [&](const auto& numbers) { document.write_array(attribute.name, padded(number_of_nodes, numbers, 0)); },
            attribute.numbers);
      });
      document.finish();
    });
  }
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a mesh with numbers of its vertices and faces as an XML file of VTK, `.vtp`, which ParaView, PyVista
/// and other programs open.
///
/// The points are in the order of `vertices(mesh)`, the cells in that of `faces(mesh)`.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param mesh the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_attributes}
///     \cgalParamDescription{numbers of the vertices: the field, or the arcs that they belong to}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_attributes}
///     \cgalParamDescription{numbers of the faces, such as their patches}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
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
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each vertex, or face
template <class FaceListGraph, class NamedParameters = parameters::Default_named_parameters>
void write_mesh_vtp(const internal::Output& output,
                    const FaceListGraph& mesh,
                    const NamedParameters& np = parameters::default_values())
{
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

  output([&](std::ostream& out) {
    const internal::Classic_locale classic_locale(out);
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
  });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_VTP_H
