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

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/IO/Color.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The base64 code: four digits for three bytes, the last of which are padded.
inline std::string base64_code(const std::vector<unsigned char>& bytes)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  auto place = text.begin();
  const auto add = [&](unsigned int group, int number_of_digits) {
    for(int i = 0; i != number_of_digits; ++i)
      *place++ = digits[group >> (18 - 6 * i) & 63];
  };
  const std::size_t rest = bytes.size() % 3;
  for(std::size_t i = 0; i != bytes.size() - rest; i += 3)
    add(bytes[i] << 16 | bytes[i + 1] << 8 | bytes[i + 2], 4);
  if(rest == 1)
    add(bytes.back() << 16, 2);
  else if(rest == 2)
    add(bytes[bytes.size() - 2] << 16 | bytes.back() << 8, 3);
  return text;
}

template <class Point>
void add_coordinates(const Point& point, std::vector<double>& coordinates)
{
  for(const double coordinate : coordinates_of(point))
    coordinates.push_back(coordinate);
}

// An XML file of VTK for points, and cells on them: vertices, lines, and polygons, in this order. Arrays are written as
// base64 codes, which other than decimal numbers can be infinite or NaN.
class Vtp_document
{
public:
  // Cells are sequences of numbers of points.
  struct Cells
  {
    std::vector<std::int64_t> points, ends; // all points, and where each cell ends

    void add_point(std::size_t point) { points.push_back(static_cast<std::int64_t>(point)); }
    void end_cell() { ends.push_back(static_cast<std::int64_t>(points.size())); }
  };

  Vtp_document(std::ostream& out,
               std::size_t number_of_points,
               const Cells& vertices,
               const Cells& lines,
               const Cells& polygons)
    : out_(out)
  {
    const bool is_little = boost::endian::order::native == boost::endian::order::little;
    out_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\""
         << (is_little ? "LittleEndian" : "BigEndian")
         << "\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" << number_of_points
         << "\" NumberOfVerts=\"" << vertices.ends.size() << "\" NumberOfLines=\"" << lines.ends.size()
         << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << polygons.ends.size() << "\">\n";
    write_cells("Verts", vertices);
    write_cells("Lines", lines);
    write_cells("Polys", polygons);
  }
  Vtp_document(const Vtp_document&) = delete;
  Vtp_document& operator=(const Vtp_document&) = delete;

  // Calls write_arrays() between the tags.
  template <class WriteArrays>
  void write_section(const std::string& tag, const std::string& active_array, const WriteArrays& write_arrays)
  {
    out_ << '<' << tag;
    if(!active_array.empty())
      out_ << " Scalars=\"" << escape_xml(active_array) << '"';
    out_ << ">\n";
    write_arrays();
    out_ << "</" << tag << ">\n";
  }

  template <class Number>
  void write_array(const std::string& name, const std::vector<Number>& numbers, std::size_t number_of_components = 1)
  {
    out_ << "<DataArray type=\"" << type_name<Number>() << "\" Name=\"" << escape_xml(name)
         << "\" NumberOfComponents=\"" << number_of_components << "\" format=\"binary\">\n";
    const std::uint64_t size = numbers.size() * sizeof(Number);
    std::vector<unsigned char> bytes(sizeof size + size);
    std::memcpy(bytes.data(), &size, sizeof size);
    if(size != 0)
      std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
    out_ << base64_code(bytes) << "\n</DataArray>\n";
  }

  // Writes the end. It is not left to a destructor, in which a stream could throw an exception.
  void finish() { out_ << "</Piece>\n</PolyData>\n</VTKFile>\n"; }

private:
  void write_cells(const std::string& tag, const Cells& cells)
  {
    write_section(tag, "", [&] {
      write_array("connectivity", cells.points);
      write_array("offsets", cells.ends);
    });
  }

  template <class Number>
  static std::string type_name()
  {
    const std::string kind = std::is_floating_point_v<Number> ? "Float" : std::is_signed_v<Number> ? "Int" : "UInt";
    return kind + std::to_string(8 * sizeof(Number));
  }

  std::ostream& out_;
};

// The points of a graph: those of its nodes, and behind them the inner ones of its arcs.
template <class Graph, class Embedding>
struct Vtp_graph
{
  Vtp_graph(const Graph& graph, const Embedding& embedding) : values(embedding.node_values)
  {
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      add_coordinates(embedding.node_points[node], coordinates);
      nodes.add_point(node);
      nodes.end_cell();
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const std::size_t i = arcs.ends.size();
      arcs.add_point(source(arc, graph));
      for(std::size_t j = 1; j + 1 < embedding.arc_polylines[i].size(); ++j)
      {
        arcs.add_point(values.size());
        add_coordinates(embedding.arc_polylines[i][j], coordinates);
        values.push_back(embedding.arc_values[i][j]);
        arc_of_point.push_back(static_cast<std::int64_t>(i));
      }
      arcs.add_point(target(arc, graph));
      arcs.end_cell();
    }
  }

  std::vector<double> coordinates, values;
  std::vector<std::int64_t> arc_of_point; // of inner points
  Vtp_document::Cells nodes, arcs;
};

// The numbers of nodes, and -1 or NaN for the rest; or the other way round.
template <class Number>
std::vector<Number> padded(std::size_t number_before, std::vector<Number> numbers, std::size_t number_behind)
{
  constexpr Number nothing = std::is_floating_point_v<Number> ? std::numeric_limits<Number>::quiet_NaN() : Number(-1);
  numbers.insert(numbers.begin(), number_before, nothing);
  numbers.insert(numbers.end(), number_behind, nothing);
  return numbers;
}

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

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

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
  static_assert(internal::are_met<internal::Graph_and_vertex_map<Graph, VertexIndexMap>>);
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
