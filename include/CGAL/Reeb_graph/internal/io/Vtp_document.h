// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_VTP_DOCUMENT_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_VTP_DOCUMENT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

inline void write_base64(std::ostream& out, std::vector<unsigned char> bytes)
{
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  typedef base64_from_binary<transform_width<std::vector<unsigned char>::const_iterator, 6, 8>> Digits;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  const std::size_t number_of_digits = (4 * bytes.size() + 2) / 3;
  bytes.resize(bytes.size() + padding, 0);
  std::string text; // in one piece: an iterator of the stream's buffer would not tell the stream that it failed
  text.reserve(number_of_digits + padding);
  std::copy_n(Digits(bytes.cbegin()), number_of_digits, std::back_inserter(text));
  out << text.append(padding, '=');
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
      out_ << " Scalars=\"" << escape(active_array) << '"';
    out_ << ">\n";
    write_arrays();
    out_ << "</" << tag << ">\n";
  }

  template <class Number>
  void write_array(const std::string& name, const std::vector<Number>& numbers, std::size_t number_of_components = 1)
  {
    out_ << "<DataArray type=\"" << type_name<Number>() << "\" Name=\"" << escape(name) << "\" NumberOfComponents=\""
         << number_of_components << "\" format=\"binary\">\n";
    const std::uint64_t size = numbers.size() * sizeof(Number);
    std::vector<unsigned char> bytes(sizeof size + size);
    std::memcpy(bytes.data(), &size, sizeof size);
    if(size != 0)
      std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
    write_base64(out_, std::move(bytes));
    out_ << "\n</DataArray>\n";
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

  static std::string escape(const std::string& text)
  {
    std::string result;
    for(const char c : xml_characters(text))
      result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_VTP_DOCUMENT_H
