// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/local_input.h"

#include "input/File_contents.h"
#include "input/input_error.h"
#include "input/ply_header.h"
#include "input/text_input.h"
#include "mpi/ranks.h"

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>

#include <boost/mpi/collectives.hpp>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr std::size_t most_bytes_at_once = std::size_t(1) << 28;

int number_of_bytes_done(MPI_Status& status)
{
  int number = 0;
  MPI_Get_count(&status, MPI_BYTE, &number);
  return number;
}

// A file of which each rank reads parts of its own by MPI-IO. Opening and closing it is no collective work: a
// rank that fails leaves no other one waiting.
class Shared_file
{
public:
  // Throws Input_error.
  explicit Shared_file(const std::string& path) : path_(path)
  {
    if(!std::filesystem::is_regular_file(path)
       || MPI_File_open(MPI_COMM_SELF, path.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL, &file_) != MPI_SUCCESS)
      throw unreadable_file(path_);
    MPI_Offset size = 0;
    MPI_File_get_size(file_, &size);
    size_ = static_cast<std::uint64_t>(size);
  }

  Shared_file(const Shared_file&) = delete;
  Shared_file& operator=(const Shared_file&) = delete;
  ~Shared_file()
  {
    if(file_ != MPI_FILE_NULL)
      MPI_File_close(&file_);
  }

  std::uint64_t size() const { return size_; }

  // The bytes have to be in the file.
  void read(std::uint64_t offset, char* bytes, std::size_t number_of_bytes) const
  {
    for(std::size_t begin = 0; begin < number_of_bytes;)
    {
      const int number = static_cast<int>(std::min(number_of_bytes - begin, most_bytes_at_once));
      MPI_Status status;
      const int error = MPI_File_read_at(file_, static_cast<MPI_Offset>(offset) + static_cast<MPI_Offset>(begin),
                                         bytes + begin, number, MPI_BYTE, &status);
      if(error != MPI_SUCCESS || number_of_bytes_done(status) != number)
        throw Input_error(path_, "the file cannot be read");
      begin += static_cast<std::size_t>(number);
    }
  }

private:
  std::string path_;
  MPI_File file_ = MPI_FILE_NULL;
  std::uint64_t size_ = 0;
};

// Where the field of a PLY file is: a function of the points or, if there is none, a property of the vertices.
struct Ply_field
{
  Field_of_point of_point;
  std::string property;
};

// Records of the same number of bytes, one after the other, in a file.
struct Records
{
  std::uint64_t offset = 0; // of the first one in the file
  std::uint64_t number = 0;
  std::size_t size = 0; // in bytes
};

// Calls the function with each record of a part, in their order, and its number.
template <class Function>
void read_records(const Shared_file& file, const Records& records, const Part& part, const Function& function)
{
  constexpr std::size_t bytes_at_once = std::size_t(1) << 22;
  const std::uint64_t records_at_once =
    std::max<std::size_t>(bytes_at_once / std::max<std::size_t>(records.size, 1), 1);
  std::vector<char> bytes;
  for(std::uint64_t first = part.first; first < part.last; first += records_at_once)
  {
    const std::uint64_t last = std::min(first + records_at_once, part.last);
    bytes.resize((last - first) * records.size);
    file.read(records.offset + first * records.size, bytes.data(), bytes.size());
    for(std::uint64_t i = first; i < last; ++i)
      function(i, bytes.data() + (i - first) * records.size);
  }
}

// Ranks look nothing over, as faces keep their numbers in the file.
constexpr const char* way_out = "; reeb_graph repair writes a file without such faces";

[[noreturn]] void fail(const std::string& path, std::uint64_t face, const std::string& message)
{
  throw Input_error(path, "face " + std::to_string(face) + message);
}

// Throws Input_error, as the sequential program does, if a vertex of the face does not exist or is at two of its
// corners.
void check_triangle(const std::string& path,
                    std::uint64_t face,
                    const std::array<std::uint64_t, 3>& corners,
                    std::uint64_t number_of_vertices)
{
  const auto [a, b, c] = corners;
  if(std::max({a, b, c}) >= number_of_vertices)
    fail(path, face, " has a vertex that does not exist");
  if(a == b || b == c || c == a)
    fail(path, face, " has vertex " + std::to_string(b == c ? b : a) + " at two of its corners" + way_out);
}

// Throws Input_error for a face that has not three corners.
[[noreturn]] void throw_for_polygon(const std::string& path, std::uint64_t face, double number_of_corners)
{
  if(number_of_corners < 3)
    fail(path, face, std::string(" has fewer than three vertices") + way_out);
  fail(path, face,
       " has " + std::to_string(static_cast<std::uint64_t>(number_of_corners))
         + " vertices and is not a triangle; reeb_graph repair --triangulate writes a file of triangles");
}

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
  Number_type size_type, type;
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
  if(i == element.properties.size() || !element.properties[i].is_list() || !is_integer(element.properties[i].type))
    layout.fail("the faces have no list of vertices");
  const ply::Property& property = element.properties[i];
  const Polygon_place place = {ply::offset_in_record(element, i), property.list_size_type, property.type,
                               layout.is_reversed()};
  const Part part = part_of_rank(communicator, element.number);
  run_together(communicator, [&] {
    call_with_number(property.type, [&](auto index) {
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

// Each rank reads its own part of a binary PLY file, whose faces are triangles. All of them throw the same exception if
// there is something wrong with the file, where the sequential program throws Input_error as well, or if its records
// differ in length. Collective.
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

// What raw files begin with.
constexpr std::string_view raw_magic = "ReebRaw1";

// Where the parts of a raw file are, which read_local_raw() describes.
class Raw_layout
{
public:
  static constexpr std::size_t size_of_header = 24;

  Raw_layout(std::uint64_t number_of_vertices, std::uint64_t number_of_triangles)
    : scalars_{size_of_header, number_of_vertices, sizeof(double)},
      triangles_{size_of_header + number_of_vertices * sizeof(double), number_of_triangles, 3 * sizeof(std::uint64_t)}
  {}

  const Records& scalars() const { return scalars_; }
  const Records& triangles() const { return triangles_; }
  std::uint64_t size() const { return triangles_.offset + triangles_.number * triangles_.size; }

private:
  Records scalars_, triangles_;
};

Raw_layout read_layout(const std::string& path, const Shared_file& file)
{
  std::array<char, Raw_layout::size_of_header> header = {};
  if(file.size() < header.size())
    throw Input_error(path, "the file ends too early");
  file.read(0, header.data(), header.size());
  if(std::string_view(header.data(), raw_magic.size()) != raw_magic)
    throw Input_error(path, "the file does not begin as a raw file");
  const std::uint64_t vertices = decode<std::uint64_t>(header.data() + 8, is_machine_big_endian());
  const std::uint64_t triangles = decode<std::uint64_t>(header.data() + 16, is_machine_big_endian());
  const std::uint64_t rest = file.size() - header.size();
  if(vertices > rest / sizeof(double) || triangles > (rest - vertices * sizeof(double)) / (3 * sizeof(std::uint64_t)))
    throw Input_error(path, "the file ends too early");
  const Raw_layout layout(vertices, triangles);
  if(layout.size() != file.size())
    throw Input_error(path, "there is more in the file than its header says");
  return layout;
}

void read_parts(const std::string& path,
                const Shared_file& file,
                const Raw_layout& layout,
                const Part& vertices,
                const Part& triangles,
                Local_mesh& mesh)
{
  const bool is_reversed = is_machine_big_endian();
  mesh.scalars.reserve(vertices.size());
  read_records(file, layout.scalars(), vertices,
               [&](std::uint64_t, const char* record) { mesh.scalars.push_back(decode<double>(record, is_reversed)); });
  std::visit(
    [&](auto& list) {
      typename std::decay_t<decltype(list)>::value_type triangle;
      list.reserve(triangles.size());
      read_records(file, layout.triangles(), triangles, [&](std::uint64_t f, const char* record) {
        std::array<std::uint64_t, 3> corners = {};
        for(std::size_t i = 0; i < 3; ++i)
          corners[i] = decode<std::uint64_t>(record + i * sizeof(std::uint64_t), is_reversed);
        check_triangle(path, f, corners, mesh.number_of_vertices);
        std::copy(corners.begin(), corners.end(), triangle.begin());
        list.push_back(triangle);
      });
    },
    mesh.triangles);
}

// The same of a raw file, which has a value for each vertex and no points. All numbers are little-endian: eight
// characters, "ReebRaw1"; the number of vertices and that of triangles, 64-bit integers; the values of the vertices,
// double numbers; and three vertices for each triangle, 64-bit integers from 0.
Local_mesh read_local_raw(const Communicator& communicator, const std::string& path)
{
  Local_mesh mesh;
  run_together(communicator, [&] {
    const Shared_file file(path);
    const Raw_layout layout = read_layout(path, file);
    mesh.number_of_vertices = layout.scalars().number;
    mesh.number_of_triangles = layout.triangles().number;
    const Part vertices = part_of_rank(communicator, mesh.number_of_vertices);
    mesh.first_vertex = vertices.first;
    mesh.triangles = make_triangles(mesh.number_of_vertices);
    read_parts(path, file, layout, vertices, part_of_rank(communicator, mesh.number_of_triangles), mesh);
  });
  return mesh;
}

bool is_coordinate(const std::string& field) { return field == "x" || field == "y" || field == "z"; }

} // namespace

Field_of_point field_of_point(const Input_options& options)
{
  if(is_coordinate(options.field))
    return [i = options.field[0] - 'x'](const Point& point) { return point[i]; };
  if(options.field != "height")
    return {};
  std::vector<double> d = options.direction;
  if(d.empty())
    d = {0, 0, 1};
  if(!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2]) || (d[0] == 0 && d[1] == 0 && d[2] == 0))
    throw CGAL::Reeb_graph::Parameter_error("the direction is zero, or not finite");
  return [d](const Point& p) { return d[0] * p.x() + d[1] * p.y() + d[2] * p.z(); };
}

Local_mesh read_local_mesh(const Communicator& communicator, const Input_options& options)
{
  const std::string extension = lower_case_extension(options.mesh_path);
  if(extension == ".raw")
  {
    if(!options.field.empty())
      throw std::runtime_error("--field does not go with a raw file, which has the values of one field");
    return read_local_raw(communicator, options.mesh_path);
  }
  if(extension != ".ply")
    throw Input_error(options.mesh_path, "ranks share binary .ply files, and .raw files");
  if(options.field.empty())
    throw std::runtime_error("a field is needed, such as --field z");
  const Field_of_point of_point = field_of_point(options);
  return read_local_ply(communicator, options.mesh_path, {of_point, of_point ? std::string() : options.field});
}

} // namespace reeb_graph_program
