// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_MESH_OUTPUT_H

#include "base/surface.h"
#include "input/Polygon_soup.h"
#include "output/output_file.h"

#include <CGAL/Reeb_graph/internal/io/text.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// Throws std::runtime_error unless the file name has an ending of a mesh: .off, .ply, .obj, .stl, or .vtp.
void check_mesh_format(const std::filesystem::path& path);

// Notes on what was asked for, and the format of a file has no room for.
typedef std::vector<std::string> Notes;

// The mesh with all digits of the coordinates: .off, .obj, or .stl, which is text and has triangles only; or with the
// numbers of its vertices, .ply or .vtp.
void write_surface(const std::filesystem::path& path, const Surface& surface, Notes& notes);

// One number per line, with all digits; .npy as NumPy has it.
template <class Number>
void write_numbers(const std::filesystem::path& path, const std::vector<Number>& numbers)
{
  write_file(path, [&](std::ostream& stream) {
    if(is_npy(path))
      return write_npy(stream, numbers);
    CGAL::Reeb_graph::internal::Text_output text(stream);
    for(const Number number : numbers)
      text << number << '\n';
    text.flush();
  });
}

// The same in the order of the vertices.
void write_scalars(const std::filesystem::path& path, const Surface& surface, Scalar_map scalar_map);

// Throws std::runtime_error if a file of numbers, one per line or .npy, is called as one of a mesh; a path may be empty.
void check_numbers_format(const std::filesystem::path& path);

// A surface for writers only, whose faces have the vertices of the polygons, and no neighbors.
Surface unconnected_surface(const std::vector<Point>& points, const Polygons& polygons);

// What is known of a mesh, to be written with it.
struct Mesh_results
{
  Scalar_map scalar_map;
  const std::vector<std::size_t>& places;                                   // of the vertices, by their indices
  std::size_t number_of_nodes = 0;                                          // of the graph
  std::optional<Patch_map> patch_map;                                       // of a mesh that has been cut
  std::optional<Patch_map> band_map = std::nullopt;                         // of one that has been cut along levels
  std::optional<Vertex_property<std::int32_t>> original_map = std::nullopt; // of one that has been cut to disks
};

// The mesh with the value, the arc, and the node of each vertex, where one of arc and node is -1; and the patch of each
// face. Patches are coloured, or else vertices by their values: .ply or .vtp, with all digits; .off has the colours alone,
// .obj and .stl have none.
void write_mesh(const std::filesystem::path& path, const Surface& surface, const Mesh_results& results, Notes& notes);

// A complex is written as its triangles.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const Mesh_results& results, Notes& notes);

// The mesh in the PLY format, with vertices coloured from dark blue, the lowest, to yellow, the highest.
void write_coloured_surface(const std::filesystem::path& path, Surface surface, Scalar_map scalar_map);

// The mesh in any format: .ply and .vtp have the patch of each face as a number, and a colour for each patch.
void write_surface_with_patches(const std::filesystem::path& path, Surface surface, Patch_map patch_map, Notes& notes);

// The mesh as .ply or .vtp, with numbers of its faces by their names, and a colour for each of the first ones.
typedef std::pair<std::string, std::vector<int>> Face_numbers;
void write_surface_with_numbers(const std::filesystem::path& path,
                                Surface surface,
                                const std::vector<Face_numbers>& columns);
void check_format_with_numbers(const std::filesystem::path& path);

// A file piece_N.ply in the folder, which is made, for the faces with each number N.
void write_pieces(const std::filesystem::path& folder, const Surface& surface, const std::vector<std::size_t>& pieces);

// Whether the format has room for numbers of vertices and faces.
bool has_room_for_numbers(const std::filesystem::path& path);

// The fields of the vertices of the input, if one of the files that are going to be written has room for them, and else
// none. Notes what is left out.
std::vector<Any_vertex_property> properties_to_keep(const std::string& input,
                                                    const std::vector<std::string>& outputs,
                                                    Surface& surface,
                                                    Notes& notes);

// Notes what the input has, as normals, that is not kept in any format.
void note_lost_parts(const std::filesystem::path& path, const std::string& input, Notes& notes);

// Notes that these are left out of the file, if there are any.
void note_left_out(const std::filesystem::path& path, const std::vector<std::string>& things, Notes& notes);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_OUTPUT_H
