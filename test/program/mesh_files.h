// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H
#define CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// The same small mesh, an octahedron, in each format that the program reads.
namespace mesh_files {
struct Mesh_file
{
  std::string name, extension, content;
};

typedef std::vector<std::vector<double>> Rows; // of numbers

inline Rows points() { return {{0, 0, -1}, {1, 0, 0}, {0, 1, 0.25}, {-1, 0, 0.5}, {0, -1, 0.125}, {0, 0, 1}}; }

inline Rows triangles()
{
  return {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {5, 1, 2}, {5, 2, 3}, {5, 3, 4}, {5, 4, 1}};
}

// Each row on a line of its own, each number less `shift`, between a prefix and a suffix.
inline std::string lines(const Rows& rows, const std::string& prefix, const std::string& suffix, double shift = 0)
{
  std::string text;
  for(const auto& row : rows)
  {
    text += prefix;
    for(std::size_t i = 0; i < row.size(); ++i)
    {
      std::string number = std::to_string(row[i] + shift);
      number.erase(number.find_last_not_of('0') + 1);
      if(number.back() == '.')
        number.pop_back();
      text += (i == 0 ? "" : " ") + number;
    }
    text += suffix + "\n";
  }
  return text;
}

// Appends numbers of a type, in the other order of bytes if they are swapped.
template <class Number>
void append(std::string& bytes, const std::vector<double>& numbers, bool are_swapped = false)
{
  for(const double number : numbers)
  {
    const auto typed = static_cast<Number>(number);
    std::string typed_bytes(sizeof(typed), '\0');
    std::memcpy(&typed_bytes[0], &typed, sizeof(typed));
    if(are_swapped)
      std::reverse(typed_bytes.begin(), typed_bytes.end());
    bytes += typed_bytes;
  }
}

inline std::string ply_header(const std::string& format, const std::string& type)
{
  return "ply\nformat " + format + " 1.0\ncomment an octahedron\nelement vertex 6\nproperty " + type + " x\nproperty "
       + type + " y\nproperty " + type + " z\nelement face 8\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string binary_ply(const std::string& format, bool are_swapped)
{
  std::string content = ply_header(format, "float");
  for(const auto& row : points())
    append<float>(content, row, are_swapped);
  for(const auto& row : triangles())
  {
    append<std::uint8_t>(content, {3});
    append<std::int32_t>(content, row, are_swapped);
  }
  return content;
}

// An ASCII file with properties and elements that a mesh does without.
inline std::string rich_ply()
{
  return "ply\nformat ascii 1.0\nobj_info none\nelement material 1\nproperty list uchar float shininess\n"
         "element vertex 6\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
         "element face 8\nproperty uchar flags\nproperty list uint8 uint32 vertex_index\nelement empty 3\nend_header\n"
         "2 0.5 0.25\n"
       + lines(points(), "", " 255") + lines(triangles(), "7 3 ", "");
}

inline std::string ascii_stl()
{
  std::string content = "solid octahedron\n";
  for(const auto& row : triangles())
  {
    content += "facet normal 0 0 0\nouter loop\n";
    for(const double v : row)
      content += lines({points()[static_cast<std::size_t>(v)]}, "vertex ", "");
    content += "endloop\nendfacet\n";
  }
  return content + "endsolid octahedron\n";
}

inline std::string binary_stl()
{
  std::string content = "an octahedron";
  content.resize(80, ' ');
  append<std::uint32_t>(content, {8});
  for(const auto& row : triangles())
  {
    append<float>(content, {0, 0, 0});
    for(const double v : row)
      append<float>(content, points()[static_cast<std::size_t>(v)]);
    append<std::uint16_t>(content, {0});
  }
  return content;
}

inline std::string ts()
{
  std::string content = "GOCAD TSurf 1\nHEADER {\nname:octahedron\n}\nTFACE\n";
  for(std::size_t i = 0; i < points().size(); ++i)
    content += lines({points()[i]}, "VRTX " + std::to_string(i + 1) + " ", "");
  return content + lines(triangles(), "TRGL ", "", 1) + "END\n";
}

inline std::vector<Mesh_file> all_mesh_files()
{
  const std::string off = "OFF\n# an octahedron\n6 8 12\n\n" + lines(points(), "", "") + lines(triangles(), "3 ", "");
  const std::string coff = "COFF\n6 8 0\n" + lines(points(), "", " 255 0 0 255") + lines(triangles(), "3 ", " 0 255 0");
  const std::string stcnoff =
    "STCN4OFF\n6 8 0\n" + lines(points(), "", " 1 0 0 1 0.5 0.5 0.5 0.25 0.75") + lines(triangles(), "3 ", "");
  const std::string obj = "# an octahedron\n" + lines(points(), "v ", "") + lines(triangles(), "f ", "", 1);
  const std::string rich_obj = "mtllib none\no octahedron\n" + lines(points(), "v ", " 1")
                             + "vt 0 0\nvn 0 0 1\ng all\nusemtl none\n" + lines(triangles(), "f ", "/1/1", 1);
  return {{"off", ".off", off},
          {"coff", ".off", coff},
          {"stcn4off", ".off", stcnoff},
          {"obj", ".obj", obj},
          {"rich_obj", ".obj", rich_obj},
          {"obj_from_the_end", ".obj", lines(points(), "v ", "") + lines(triangles(), "f ", "", -6)},
          {"ascii_ply", ".ply", ply_header("ascii", "double") + lines(points(), "", "") + lines(triangles(), "3 ", "")},
          {"rich_ply", ".ply", rich_ply()},
          {"little_endian_ply", ".ply", binary_ply("binary_little_endian", false)},
          {"big_endian_ply", ".ply", binary_ply("binary_big_endian", true)},
          {"ascii_stl", ".stl", ascii_stl()},
          {"binary_stl", ".stl", binary_stl()},
          {"ts", ".ts", ts()}};
}

} // namespace mesh_files

#endif // CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H
