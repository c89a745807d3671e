// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H
#define CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H

#include <zlib.h>

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

// Each triangle is a strip of its own; the edges are some of theirs.
inline std::string ply_of_strips(bool is_binary)
{
  std::string header = ply_header(is_binary ? "binary_little_endian" : "ascii", "double"), numbers;
  header.replace(header.find("element face"), std::string::npos,
                 "element edge 2\nproperty int vertex1\nproperty int vertex2\nelement tristrips 1\n"
                 "property list int int vertex_indices\nend_header\n");
  if(!is_binary)
  {
    for(const auto& row : triangles())
      numbers += lines({row}, "", " -1");
    return header + lines(points(), "", "") + "0 1\n5 2\n32 " + numbers;
  }
  for(const auto& row : points())
    append<double>(header, row);
  append<std::int32_t>(header, {0, 1, 5, 2, 32});
  for(const auto& row : triangles())
  {
    append<std::int32_t>(header, row);
    append<std::int32_t>(header, {-1});
  }
  return header;
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

// The octahedron around an axis: with these tetrahedra, the field z has the same graph.
inline Rows tetrahedra() { return {{0, 5, 1, 2}, {0, 5, 2, 3}, {0, 5, 3, 4}, {0, 5, 4, 1}}; }

inline std::string medit(const std::string& section, const Rows& cells)
{
  return "MeshVersionFormatted 2\nDimension\n3\n# an octahedron\nVertices\n6\n" + lines(points(), "", " 0")
       + "Corners\n2\n1\n6\nEdges\n1\n1 2 0\n" + section + "\n" + std::to_string(cells.size()) + "\n"
       + lines(cells, "", " 1", 1) + "End\n";
}

inline std::string vtk(const Rows& cells, const std::string& type)
{
  const std::size_t size = cells.front().size();
  std::string content = "# vtk DataFile Version 3.0\nan octahedron\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n"
                      + lines(points(), "", "") + "CELLS " + std::to_string(cells.size()) + " "
                      + std::to_string(cells.size() * (size + 1)) + "\n" + lines(cells, std::to_string(size) + " ", "")
                      + "CELL_TYPES " + std::to_string(cells.size()) + "\n";
  for(std::size_t i = 0; i < cells.size(); ++i)
    content += type + "\n";
  return content + "POINT_DATA 6\nSCALARS mass double 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\nVECTORS force float\n"
       + lines(points(), "", "");
}

inline std::string vtk_5()
{
  return "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n" + lines(points(), "", "")
       + "METADATA\nINFORMATION 0\n\nPOLYGONS 9 24\nOFFSETS vtktypeint64\n0 3 6 9 12 15 18 21 24\n"
         "CONNECTIVITY vtktypeint64\n"
       + lines(triangles(), "", "") + "\nPOINT_DATA 6\nFIELD FieldData 1\nmass 1 6 double\n1 2 3 4 5 6\n";
}

inline void append_line(std::string& bytes, const std::string& line) { bytes += line + "\n"; }

// Binary, whose numbers begin with their highest byte, as version 4.2 and 5.1 have cells.
inline std::string binary_vtk(bool is_version_5)
{
  std::string content = "# vtk DataFile Version " + std::string(is_version_5 ? "5.1" : "4.2");
  append_line(content, "\nan octahedron\nBINARY\nDATASET POLYDATA\nPOINTS 6 double");
  for(const auto& row : points())
    append<double>(content, row, true);
  append_line(content,
              is_version_5 ? "\nMETADATA\nINFORMATION 0\n\nPOLYGONS 9 24\nOFFSETS vtktypeint64" : "\nPOLYGONS 8 32");
  if(is_version_5)
  {
    append<std::int64_t>(content, {0, 3, 6, 9, 12, 15, 18, 21, 24}, true);
    append_line(content, "\nCONNECTIVITY vtktypeint64");
  }
  for(const auto& row : triangles())
    if(is_version_5)
      append<std::int64_t>(content, row, true);
    else
    {
      append<std::int32_t>(content, {3}, true);
      append<std::int32_t>(content, row, true);
    }
  append_line(content, "\nPOINT_DATA 6\nSCALARS mass float 1\nLOOKUP_TABLE default");
  append<float>(content, {1, 2, 3, 4, 5, 6}, true);
  append_line(content, "\nFIELD FieldData 2\nlong 2 6 long");
  append<std::int64_t>(content, std::vector<double>(12, -1), true);
  append_line(content, "\nname 1 1 string");
  content += "\xc3"
             "abc";
  return content + "\n";
}

inline std::string vtu_begin(std::size_t number_of_cells)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt32\">\n<!-- an octahedron -->\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"6\" "
         "NumberOfCells=\""
       + std::to_string(number_of_cells) + "\">\n";
}

inline std::string vtu_array(const std::string& name, const std::string& type, const std::string& data)
{
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + (name == "Points" ? "3" : "1")
       + "\" " + data;
}

inline std::string ascii_vtu()
{
  const auto array = [](const std::string& name, const std::string& type, const std::string& numbers) {
    return vtu_array(name, type, "format=\"ascii\">\n" + numbers + "</DataArray>\n");
  };
  return vtu_begin(4) + "<PointData Scalars=\"mass\">\n" + array("mass", "Float64", "1 2 3 4 5 6\n")
       + "</PointData>\n<CellData/>\n<Points>\n" + array("Points", "Float32", lines(points(), "", ""))
       + "</Points>\n<Cells>\n" + array("connectivity", "Int64", lines(tetrahedra(), "", ""))
       + array("offsets", "Int64", "4 8 12 16\n") + array("types", "UInt8", "10 10 10 10\n")
       + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// Bytes behind their number.
template <class Number>
std::string vtu_block(const Rows& rows)
{
  std::string bytes, block;
  for(const auto& row : rows)
    append<Number>(bytes, row);
  append<std::uint32_t>(block, {static_cast<double>(bytes.size())});
  return block + bytes;
}

inline std::string base64_code(const std::string& bytes)
{
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string code;
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for(std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for(std::size_t j = 0; j < 4; ++j)
      code += i + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return code;
}

// With raw data behind all elements, or with base64 code inside.
inline std::string binary_vtu(bool is_appended)
{
  std::string content = vtu_begin(8), appended;
  const auto add_array = [&](const std::string& name, const std::string& type, const std::string& block) {
    const std::string offset = std::to_string(appended.size());
    content += vtu_array(name, type,
                         is_appended ? "format=\"appended\" offset=\"" + offset + "\"/>\n"
                                     : "format=\"binary\">\n" + base64_code(block) + "\n</DataArray>\n");
    appended += block;
  };
  content += "<Points>\n";
  add_array("Points", "Float64", vtu_block<double>(points()));
  content += "</Points>\n<Cells>\n";
  add_array("connectivity", "Int32", vtu_block<std::int32_t>(triangles()));
  add_array("offsets", "Int32", vtu_block<std::int32_t>({{3, 6, 9, 12, 15, 18, 21, 24}}));
  add_array("types", "UInt8", vtu_block<std::uint8_t>({{5, 5, 5, 5, 5, 5, 5, 5}}));
  content += "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
  return content + (is_appended ? "<AppendedData encoding=\"raw\">\n_" + appended + "</AppendedData>\n" : "")
       + "</VTKFile>\n";
}

// The field z of the octahedron as an array of NumPy.
inline std::string npy(const std::string& type)
{
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (6,), }", content = "\x93NUMPY\x01";
  header.resize(117, ' ');
  content += '\0';
  append<std::uint16_t>(content, {118});
  content += header + "\n";
  for(const auto& row : points())
    if(type == "<f8")
      append<double>(content, {row[2]});
    else
      append<float>(content, {row[2]}, true);
  return content;
}

// The same as text.
inline std::vector<Mesh_file> all_scalar_files()
{
  std::string text, csv = "\"name, of it\",5\" z,more\n";
  for(const auto& row : points())
  {
    text += lines({{row[2]}}, "", "");
    csv += lines({{row[2]}}, "a \"b\",", ",\"\"\"\"");
  }
  return {
    {"npy", ".npy", npy("<f8")}, {"swapped_npy", ".npy", npy(">f4")}, {"text", ".txt", text}, {"csv", ".csv", csv}};
}

// Blocks that zlib has compressed, of so many bytes but for the last one, behind their sizes. The header is a code of its
// own in base64.
inline std::string compressed_block(const std::string& bytes, std::size_t size, bool is_base64)
{
  std::vector<double> header = {0, static_cast<double>(size), static_cast<double>(bytes.size() % size)};
  std::string blocks;
  for(std::size_t begin = 0; begin < bytes.size(); begin += size)
  {
    const std::string part = bytes.substr(begin, size);
    uLongf length = compressBound(static_cast<uLong>(part.size()));
    std::string block(length, '\0');
    compress(reinterpret_cast<Bytef*>(&block[0]), &length, reinterpret_cast<const Bytef*>(part.data()),
             static_cast<uLong>(part.size()));
    blocks += block.substr(0, length);
    ++header[0];
    header.push_back(static_cast<double>(length));
  }
  std::string header_bytes;
  append<std::uint64_t>(header_bytes, header);
  return is_base64 ? base64_code(header_bytes) + base64_code(blocks) : header_bytes + blocks;
}

template <class Number>
std::string bytes_of(const Rows& rows)
{
  std::string bytes;
  for(const auto& row : rows)
    append<Number>(bytes, row);
  return bytes;
}

// Polygonal data, of which two triangles are a strip: inside in base64 code, or appended, raw or in base64 code.
inline std::string compressed_vtp(bool is_appended, bool is_base64)
{
  std::string content =
    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
    "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<Piece NumberOfPoints=\"6\" NumberOfVerts=\"1\" "
    "NumberOfLines=\"1\" NumberOfStrips=\"1\" NumberOfPolys=\"6\">\n";
  std::string appended;
  const auto add_array = [&](const std::string& name, const std::string& type, const std::string& bytes) {
    const std::string block = compressed_block(bytes, 64, is_base64), offset = std::to_string(appended.size());
    content += vtu_array(name, type,
                         is_appended ? "format=\"appended\" offset=\"" + offset + "\"/>\n"
                                     : "format=\"binary\">\n" + block + "\n</DataArray>\n");
    appended += block;
  };
  const auto add_cells = [&](const std::string& section, const Rows& cells, const std::vector<double>& ends) {
    content += "<" + section + ">\n";
    add_array("connectivity", "Int64", bytes_of<std::int64_t>(cells));
    add_array("offsets", "Int64", bytes_of<std::int64_t>({ends}));
    content += "</" + section + ">\n";
  };
  content += "<PointData>\n";
  add_array("mass &lt; 1", "Float64", bytes_of<double>({{1, 2, 3, 4, 5, 6}}));
  content += "</PointData>\n<Points>\n";
  add_array("Points", "Float32", bytes_of<float>(points()));
  content += "</Points>\n";
  Rows polygons = triangles();
  polygons.erase(polygons.begin(), polygons.begin() + 2);
  add_cells("Verts", {{4}}, {1});
  add_cells("Lines", {{1, 0, 2}}, {3});
  add_cells("Strips", {{1, 0, 2, 3}}, {4});
  add_cells("Polys", polygons, {3, 6, 9, 12, 15, 18});
  content += "</Piece>\n</PolyData>\n";
  return content
       + (is_appended ? "<AppendedData encoding=\"" + std::string(is_base64 ? "base64" : "raw") + "\">\n_" + appended
                          + "\n</AppendedData>\n"
                      : "")
       + "</VTKFile>\n";
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
  const std::string mark = "\xEF\xBB\xBF";
  std::string upper_stl = ascii_stl();
  for(char& c : upper_stl)
    c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return {{"off", ".off", off},
          {"coff", ".off", coff},
          {"stcn4off", ".off", stcnoff},
          {"obj", ".obj", obj},
          {"rich_obj", ".obj", rich_obj},
          {"marked_obj", ".obj", mark + "$ an octahedron\nunknown 1\n" + obj + "l 1 2\n"},
          {"obj_from_the_end", ".obj", lines(points(), "v ", "") + lines(triangles(), "f ", "", -6)},
          {"ascii_ply", ".ply", ply_header("ascii", "double") + lines(points(), "", "") + lines(triangles(), "3 ", "")},
          {"rich_ply", ".ply", rich_ply()},
          {"little_endian_ply", ".ply", binary_ply("binary_little_endian", false)},
          {"big_endian_ply", ".ply", binary_ply("binary_big_endian", true)},
          {"ply_of_strips", ".ply", ply_of_strips(false)},
          {"binary_ply_of_strips", ".ply", ply_of_strips(true)},
          {"ascii_stl", ".stl", ascii_stl()},
          {"upper_stl", ".stl", mark + upper_stl},
          {"trailing_stl", ".stl", binary_stl() + "more bytes behind the last triangle"},
          {"binary_stl", ".stl", binary_stl()},
          {"ts", ".ts", ts()},
          {"medit", ".mesh", medit("Triangles", triangles())},
          {"medit_tetrahedra", ".mesh", medit("Tetrahedra", tetrahedra())},
          {"vtk", ".vtk", vtk(triangles(), "5")},
          {"vtk_tetrahedra", ".vtk", vtk(tetrahedra(), "10")},
          {"vtk_5", ".vtk", vtk_5()},
          {"binary_vtk", ".vtk", binary_vtk(false)},
          {"binary_vtk_5", ".vtk", binary_vtk(true)},
          {"compressed_vtp", ".vtp", compressed_vtp(false, true)},
          {"appended_compressed_vtp", ".vtp", compressed_vtp(true, false)},
          {"appended_base64_compressed_vtp", ".vtp", compressed_vtp(true, true)},
          {"ascii_vtu", ".vtu", ascii_vtu()},
          {"base64_vtu", ".vtu", binary_vtu(false)},
          {"appended_vtu", ".vtu", binary_vtu(true)}};
}

} // namespace mesh_files

#endif // CGAL_REEB_GRAPH_TEST_PROGRAM_MESH_FILES_H
