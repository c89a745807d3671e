// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/binary_numbers.h"
#include "input/text_input.h"
#include "mpi/Shared_file.h"
#include "mpi/commands_on_ranks.h"
#include "mpi/raw_format.h"
#include "output/output_file.h"

#include <boost/mpi/collectives.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
// Writes what comes one after the other into a file, from a place on.
class Sequential_output
{
public:
  Sequential_output(Shared_file& file, std::uint64_t offset) : file_(file), offset_(offset)
  {
    bytes_.reserve(capacity);
  }

  template <class Number>
  void put(Number number)
  {
    std::array<char, sizeof(Number)> bytes = {};
    encode(number, bytes.data());
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    if(bytes_.size() + sizeof(double) > capacity)
      flush();
  }

  void flush()
  {
    file_.write(offset_, bytes_.data(), bytes_.size());
    offset_ += bytes_.size();
    bytes_.clear();
  }

private:
  static constexpr std::size_t capacity = std::size_t(1) << 22;

  Shared_file& file_;
  std::uint64_t offset_;
  std::vector<char> bytes_;
};

// What the files have in common: a header, vertices, and triangles.
class Mesh_format
{
public:
  Mesh_format(const Formula_surface& surface, const Generate_options& options)
    : surface_(surface),
      field_(generated_field(options.input)),
      is_raw_(lower_case_extension(options.path) == ".raw"),
      has_values_(is_raw_ || options.input.field == "smooth" || options.input.field == "noise")
  {
    if(is_raw_)
      header_ = raw_header();
    else if(lower_case_extension(options.path) == ".ply")
      header_ = ply_header(options.input.field);
    else
      throw std::runtime_error(options.path + ": the file name of a generated mesh ends in .ply or .raw");
  }

  const std::string& header() const { return header_; }

  void write_vertices(Shared_file& file, const Part& part) const
  {
    Sequential_output out(file, header_.size() + part.first * size_of_vertex());
    std::uint64_t v = part.first;
    surface_.for_each_point(part.first, part.last, [&](const Formula_surface::Point_of_formula& p) {
      if(!is_raw_)
        for(const double coordinate : p)
          out.put(coordinate);
      if(has_values_)
        out.put(field_(v++, Point(p[0], p[1], p[2])));
    });
    out.flush();
  }

  // Those of cells, of which each has four.
  void write_triangles(Shared_file& file, const Part& cells) const
  {
    Sequential_output out(file, header_.size() + surface_.number_of_vertices() * size_of_vertex()
                                  + 4 * cells.first * size_of_triangle());
    surface_.for_each_triangle(cells.first, cells.last, [&](const Formula_surface::Triangle& triangle) {
      if(!is_raw_)
        out.put(std::uint8_t(3));
      for(const std::uint64_t corner : triangle)
        if(is_raw_)
          out.put(corner);
        else
          out.put(static_cast<std::uint32_t>(corner));
    });
    out.flush();
  }

private:
  std::size_t size_of_vertex() const { return ((is_raw_ ? 0 : 3) + (has_values_ ? 1 : 0)) * sizeof(double); }
  std::size_t size_of_triangle() const { return is_raw_ ? 3 * sizeof(std::uint64_t) : 1 + 3 * sizeof(std::uint32_t); }

  std::string raw_header() const
  {
    std::string header(raw_magic);
    header.resize(Raw_layout::size_of_header);
    encode(surface_.number_of_triangles(), encode(surface_.number_of_vertices(), header.data() + raw_magic.size()));
    return header;
  }

  std::string ply_header(const std::string& field) const
  {
    if(surface_.number_of_vertices() > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("PLY files number vertices with 32 bits: so large a surface goes into a .raw file");
    std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(surface_.number_of_vertices()) + "\n";
    for(const char* coordinate : {"x", "y", "z"})
      header += std::string("property double ") + coordinate + "\n";
    if(has_values_)
      header += "property double " + field + "\n";
    return header + "element face " + std::to_string(surface_.number_of_triangles())
         + "\nproperty list uchar uint vertex_indices\nend_header\n";
  }

  const Formula_surface& surface_;
  std::function<double(std::uint64_t, const Point&)> field_;
  bool is_raw_, has_values_; // otherwise the field follows from the points
  std::string header_;
};

// Into a file that is there. Collective.
void write_parts(const Communicator& communicator,
                 const std::string& path,
                 const std::string& shown_path,
                 const Formula_surface& surface,
                 const Mesh_format& format)
{
  run_together(communicator, [&] {
    Shared_file file(path, Shared_file::Access::WRITE, shown_path);
    if(communicator.rank() == 0)
      file.write(0, format.header().data(), format.header().size());
    format.write_vertices(file, part_of_rank(communicator, surface.number_of_vertices()));
    format.write_triangles(file, part_of_rank(communicator, surface.number_of_cells()));
    file.close();
  });
}

} // namespace

void run_generate(const Communicator& communicator, const Generate_options& options)
{
  const Formula_surface surface = make_surface(options.generation);
  const Mesh_format format(surface, options);
  bool is_told = false;
  const auto write = [&](const std::filesystem::path& temporary_path) {
    std::string path = temporary_path.string();
    boost::mpi::broadcast(communicator, path, 0);
    is_told = true;
    if(!path.empty()) // the ranks come back alike, or throw alike
      write_parts(communicator, path, options.path, surface, format);
  };
  run_together(communicator, [&] {
    if(communicator.rank() != 0)
      return write({});
    try
    {
      replace_file(options.path, write);
    }
    catch(const std::exception&)
    {
      if(!is_told)
        write({});
      throw;
    }
  });
}

} // namespace reeb_graph_program
