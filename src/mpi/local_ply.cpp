// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/binary_numbers.h"
#include "input/ply_header.h"
#include "input/ply_records.h"
#include "mpi/Records.h"
#include "mpi/check_triangles.h"
#include "mpi/local_files.h"

#include <CGAL/Reeb_graph/exceptions.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace reeb_graph_program {
namespace {
using ply::Column;

// The place of the list of the vertices of a face.
std::size_t find_polygon(const ply::Element& element) { return element.find({"vertex_indices", "vertex_index"}); }

// The parts of a PLY file, as far as its header tells.
class Ply_layout
{
public:
  Ply_layout(const std::string& path, std::string_view begin_of_file, std::uint64_t size_of_file)
    : input_(path, begin_of_file),
      header_(ply::read_header(input_)),
      end_(begin_of_file.size() - input_.rest().size())
  {
    if(header_.format == ply::Format::ASCII)
      input_.fail("the numbers of the file are text: ranks share PLY files that are binary");
    for(const ply::Element& element : header_.elements)
      add(element, size_of_file);
  }

  const ply::Element* vertices() const { return vertices_; }
  const ply::Element* faces() const { return faces_; }
  const Records& vertex_records() const { return vertex_records_; }
  const Records& face_records() const { return face_records_; }
  bool is_reversed() const { return (header_.format == ply::Format::BINARY_BIG_ENDIAN) != is_machine_big_endian(); }
  std::uint64_t end() const { return end_; } // of all records
  const Text_input& input() const { return input_; }
  const ply::Header& header() const { return header_; }

  [[noreturn]] void fail(const std::string& message) const { input_.fail(message); }

private:
  void add(const ply::Element& element, std::uint64_t size_of_file)
  {
    const bool are_vertices = element.is_vertex(), are_faces = element.is_face();
    if(!are_vertices && !are_faces)
      ply::refuse_geometry(input_, element);
    if((are_vertices && vertices_ != nullptr) || (are_faces && faces_ != nullptr))
      fail("there are two elements of " + element.name);
    const std::size_t place_of_polygon = are_faces ? find_polygon(element) : element.properties.size();
    Records records = {end_, element.number, 0};
    for(const ply::Property& property : element.properties)
    {
      const bool is_polygon = &property == element.properties.data() + place_of_polygon;
      if(property.is_list() && !is_polygon && element.number > 0)
        fail("the property " + quote(property.name) + " of the element " + quote(element.name)
             + " is a list: ranks share PLY files with no other lists than the vertices of faces");
      records.size += ply::size_in_record(property);
    }
    if(records.size > 0 && records.number > (size_of_file - end_) / records.size)
      fail("the file ends too early");
    end_ += records.number * records.size;
    if(are_vertices)
      std::tie(vertices_, vertex_records_) = std::make_pair(&element, records);
    if(are_faces)
      std::tie(faces_, face_records_) = std::make_pair(&element, records);
  }

  Text_input input_;
  ply::Header header_;
  std::uint64_t end_;
  const ply::Element* vertices_ = nullptr;
  const ply::Element* faces_ = nullptr;
  Records vertex_records_, face_records_;
};

// The points, and the values if they are a property, of the vertices.
class Vertex_columns
{
public:
  Vertex_columns(const Ply_layout& layout, const std::string& property)
    : x_(coordinate(layout, "x")),
      y_(coordinate(layout, "y")),
      z_(coordinate(layout, "z"))
  {
    if(property.empty())
      return;
    const ply::Element& element = *layout.vertices();
    const std::size_t place = ply::find_scalars(layout.input(), layout.header(), element, property);
    scalar_.emplace(element, place, layout.is_reversed());
  }

  Point point(const char* record) const { return Point(x_(record), y_(record), z_(record)); }
  double scalar(const char* record) const { return (*scalar_)(record); }

private:
  static Column coordinate(const Ply_layout& layout, std::string_view name)
  {
    const ply::Element* const element = layout.vertices();
    const std::size_t place = element == nullptr ? 0 : element->find({name});
    if(element == nullptr || place == element->properties.size() || element->properties[place].is_list())
      layout.fail("the vertices have no x, y and z");
    return Column(*element, place, layout.is_reversed());
  }

  Column x_, y_, z_;
  std::optional<Column> scalar_;
};

// The first bytes of the file, which hold its header, as rank 0 reads them.
std::string read_begin(const Communicator& communicator, const Shared_file& file)
{
  constexpr std::uint64_t longest_header = 1 << 20;
  std::string bytes;
  run_on_rank_0(communicator, [&] {
    bytes.resize(std::min(file.size(), longest_header));
    file.read(0, bytes.data(), bytes.size());
  });
  boost::mpi::broadcast(communicator, bytes, 0);
  return bytes;
}

void read_vertices(const Communicator& communicator,
                   const std::string& path,
                   const Shared_file& file,
                   const Records& records,
                   const Vertex_columns& columns,
                   const Field_of_point& of_point,
                   Local_mesh& mesh)
{
  const Part part = part_of_rank(communicator, records.number);
  mesh.first_vertex = part.first;
  run_together(communicator, [&] {
    mesh.scalars.reserve(part.size());
    read_records(file, records, part, [&](std::uint64_t v, const char* record) {
      const Point point = columns.point(record);
      if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z()))
        throw Input_error(path, "vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
      mesh.scalars.push_back(of_point ? of_point(point) : columns.scalar(record));
      if(of_point && !std::isfinite(mesh.scalars.back()))
        throw CGAL::Reeb_graph::Non_finite_scalar_error(v);
    });
  });
}

// Where the vertices of a face are in its record.
struct Polygon_place
{
  std::size_t offset;
  ply::Type size_type, type;
  bool is_reversed;
};

template <class Index>
void read_triangles(const std::string& path,
                    const Shared_file& file,
                    const Records& records,
                    const Part& part,
                    const Polygon_place& place,
                    Local_mesh& mesh)
{
  const std::size_t begin_of_corners = place.offset + ply::size_in_bytes(place.size_type);
  std::visit(
    [&](auto& list) {
      typename std::decay_t<decltype(list)>::value_type triangle;
      std::array<std::uint64_t, 3> corners = {};
      list.reserve(part.size());
      read_records(file, records, part, [&](std::uint64_t f, const char* record) {
        const double size = ply::decode_number(place.size_type, record + place.offset, place.is_reversed);
        if(size != 3)
          throw_for_polygon(path, f, size);
        for(std::size_t i = 0; i < 3; ++i) // a negative number becomes one that is too large
          corners[i] = static_cast<std::uint64_t>(
            std::int64_t{decode<Index>(record + begin_of_corners + i * sizeof(Index), place.is_reversed)});
        check_triangle(path, f, corners, mesh.number_of_vertices);
        std::copy(corners.begin(), corners.end(), triangle.begin());
        list.push_back(triangle);
      });
    },
    mesh.triangles);
}

void read_faces(const Communicator& communicator,
                const std::string& path,
                const Shared_file& file,
                const Ply_layout& layout,
                Local_mesh& mesh)
{
  const ply::Element& element = *layout.faces();
  const std::size_t i = find_polygon(element);
  if(i == element.properties.size() || !element.properties[i].is_list() || !ply::is_integer(element.properties[i].type))
    layout.fail("the faces have no list of vertices");
  const ply::Property& property = element.properties[i];
  const Polygon_place place = {ply::offset_in_record(element, i), property.list_size_type, property.type,
                               layout.is_reversed()};
  const Part part = part_of_rank(communicator, element.number);
  run_together(communicator, [&] {
    ply::call_with_number(property.type, [&](auto index) {
      if constexpr(std::is_integral_v<decltype(index)>)
        read_triangles<decltype(index)>(path, file, layout.face_records(), part, place, mesh);
    });
  });
}

// Only blanks may be behind the records.
void check_end(const Shared_file& file, const Ply_layout& layout)
{
  constexpr std::uint64_t most_blanks = 1 << 20;
  std::string bytes(std::min(file.size() - layout.end(), most_blanks + 1), ' ');
  file.read(layout.end(), bytes.data(), bytes.size());
  if(bytes.size() > most_blanks
     || !std::all_of(bytes.begin(), bytes.end(), [](unsigned char c) { return std::isspace(c) != 0; }))
    layout.fail("there is more in the file than its header says");
}

} // namespace

Local_mesh read_local_ply(const Communicator& communicator, const std::string& path, const Ply_field& field)
{
  std::shared_ptr<const Shared_file> file;
  run_together(communicator, [&] { file = std::make_shared<Shared_file>(path); });
  const std::string begin = read_begin(communicator, *file);
  const Ply_layout layout(path, begin, file->size());
  const Vertex_columns columns(layout, field.property);
  const Records records = layout.vertex_records();
  Local_mesh mesh;
  mesh.number_of_vertices = records.number;
  mesh.triangles = make_triangles(records.number);
  read_vertices(communicator, path, *file, records, columns, field.of_point, mesh);
  if(layout.faces() != nullptr)
  {
    mesh.number_of_triangles = layout.faces()->number;
    read_faces(communicator, path, *file, layout, mesh);
  }
  run_on_rank_0(communicator, [&] { check_end(*file, layout); });
  mesh.point = [file, records, columns](std::uint64_t v) {
    Point point;
    read_records(*file, records, {v, v + 1}, [&](std::uint64_t, const char* record) { point = columns.point(record); });
    return point;
  };
  return mesh;
}

} // namespace reeb_graph_program
