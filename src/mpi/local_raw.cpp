// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/binary_numbers.h"
#include "input/input_error.h"
#include "mpi/Records.h"
#include "mpi/check_triangles.h"
#include "mpi/local_files.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace reeb_graph_program {
namespace {
// What raw files begin with.
constexpr std::string_view raw_magic = "ReebRaw1";

// Where the parts of a raw file are, which local_files.h describes.
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

} // namespace

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

} // namespace reeb_graph_program
