// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
struct Off_header
{
  std::size_t coordinates = 3; // of a point
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

// The next word that is not in a comment; words may be on any line.
std::string_view next_word_of_file(Text_input& input)
{
  std::string_view word = input.word_of_line();
  while(word.empty() && input.next_line())
  {
    input.remove_comment('#');
    word = input.word_of_line();
  }
  return word;
}

// Goes to the next line that has a word.
bool next_line_of_words(Text_input& input)
{
  while(input.next_line())
  {
    input.remove_comment('#');
    if(!input.next_word_of_line().empty())
      return true;
  }
  return false;
}

// The number of coordinates that the first word of the file says.
std::size_t read_keyword(Text_input& input)
{
  std::string_view keyword = next_word_of_file(input);
  const auto remove = [&](std::string_view prefix) {
    const bool is_there = keyword.substr(0, prefix.size()) == prefix;
    keyword.remove_prefix(is_there ? prefix.size() : 0);
    return is_there;
  };
  remove("ST");
  remove("C");
  remove("N");
  const bool is_homogeneous = remove("4");
  if(keyword != "OFF")
    input.fail("the file does not begin as an OFF file");
  return is_homogeneous ? 4 : 3;
}

Off_header read_header(Text_input& input)
{
  Off_header header;
  header.coordinates = read_keyword(input);
  const std::string_view word = next_word_of_file(input);
  if(word == "BINARY")
    input.fail("binary OFF files are not read");
  header.vertices = input.number<std::size_t>(word);
  header.faces = input.number<std::size_t>(next_word_of_file(input));
  input.number<std::size_t>(next_word_of_file(input)); // of edges
  if(!input.word_of_line().empty())
    input.fail("there is more than the numbers of vertices, faces and edges");
  return header;
}

// Colours, normals and textures are numbers as well.
void skip_numbers(Text_input& input)
{
  for(std::string_view word = input.word_of_line(); !word.empty(); word = input.word_of_line())
    input.number<double>(word);
}

Point read_point(Text_input& input, std::size_t number_of_coordinates)
{
  std::array<double, 4> coordinates = {0, 0, 0, 1};
  for(std::size_t i = 0; i < number_of_coordinates; ++i)
    coordinates[i] = input.number<double>(input.word_of_line());
  const auto [x, y, z, w] = coordinates;
  return Point(x / w, y / w, z / w);
}

void read_polygon(Text_input& input, Polygons& polygons)
{
  for(auto size = input.number<std::size_t>(input.word_of_line()); size > 0; --size)
    polygons.add_corner(input.number<std::size_t>(input.word_of_line()));
  polygons.end_polygon();
}

std::size_t count_lines_of_words(Text_input& input)
{
  std::size_t number = 0;
  while(next_line_of_words(input))
    ++number;
  return number;
}

// Reads what is behind the header, or the part of it that has so many vertices and faces before it.
Polygon_soup read_lines(Text_input& input, const Off_header& header, std::size_t number_before)
{
  Polygon_soup soup;
  for(std::size_t number = number_before; next_line_of_words(input); ++number)
  {
    if(number < header.vertices)
      soup.points.push_back(read_point(input, header.coordinates));
    else if(number - header.vertices < header.faces)
      read_polygon(input, soup.polygons);
    else
      input.fail("there are more faces than the " + std::to_string(header.faces) + " that the header says");
    skip_numbers(input);
  }
  return soup;
}

} // namespace

Polygon_soup read_off(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const Off_header header = read_header(input);
  const Text_blocks blocks(input);
  const std::vector<std::size_t> before = blocks.count_before(count_lines_of_words);
  std::vector<Polygon_soup> parts(blocks.size());
  run_tasks(blocks.size(), [&](std::size_t i) {
    Text_input block = blocks.input(i);
    parts[i] = read_lines(block, header, before[i]);
  });
  Polygon_soup soup = join(std::move(parts));
  if(soup.points.size() < header.vertices || soup.polygons.size() < header.faces)
    throw Input_error(path, blocks.number_of_lines(),
                      "the file ends after " + std::to_string(soup.points.size()) + " of "
                        + std::to_string(header.vertices) + " vertices and " + std::to_string(soup.polygons.size())
                        + " of " + std::to_string(header.faces) + " faces");
  return soup;
}

namespace {
template <std::size_t size>
bool is_one_of(const std::array<std::string_view, size>& keywords, std::string_view keyword)
{
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// What a mesh does without: parameters, normals, names, materials, points.
bool is_skipped_keyword(std::string_view keyword)
{
  static constexpr std::array<std::string_view, 33> keywords = {
    "vt",     "vn",     "vp",     "g",     "o",     "s",    "p",          "bevel",     "lod",    "c_interp", "d_interp",
    "usemap", "usemtl", "mtllib", "ctech", "stech", "end",  "shadow_obj", "trace_obj", "cstype", "deg",      "step",
    "bmat",   "con",    "parm",   "trim",  "hole",  "scrv", "sp",         "mg",        "maplib", "res",      "csh"};
  return is_one_of(keywords, keyword);
}

// What would be a part of the mesh: curves, surfaces, and patches of free form, and other files.
bool is_geometry_not_read(std::string_view keyword)
{
  static constexpr std::array<std::string_view, 8> keywords = {"curv", "curv2", "surf", "bsp",
                                                               "bzp",  "cdc",   "cdp",  "call"};
  return is_one_of(keywords, keyword);
}

// The vertex of a corner: its number, from 1, or counted backwards from -1, and possibly more behind slashes.
std::size_t read_corner(const Text_input& input, std::string_view word, std::size_t number_of_earlier)
{
  const std::string_view digits = word.substr(0, word.find('/'));
  long long vertex = 0;
  const auto earlier = static_cast<long long>(number_of_earlier);
  if(parse_number(digits, vertex) != std::errc() || vertex == 0 || vertex < -earlier)
    input.fail(quote(word) + " is not a vertex of a face");
  return static_cast<std::size_t>(vertex > 0 ? vertex - 1 : earlier + vertex);
}

// The vertices of a face or a line. Returns the highest one, 0 if there is none.
std::size_t read_corners(Text_input& input, std::size_t number_of_earlier, std::vector<std::size_t>& corners)
{
  corners.clear();
  for(std::string_view word = input.word_of_line(); !word.empty(); word = input.word_of_line())
    corners.push_back(read_corner(input, word, number_of_earlier));
  return corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end());
}

// Goes to the next line, and returns whether there is one.
bool next_joined_line(Text_input& input)
{
  if(!input.next_line())
    return false;
  input.remove_comment('#');
  input.join_next_line();
  if(input.next_word_of_line().substr(0, 1) == "$") // another mark of comments
    input.remove_comment('$');
  return true;
}

std::size_t count_points(Text_input& input)
{
  std::size_t number = 0;
  while(next_joined_line(input))
    number += input.next_word_of_line() == "v" ? 1 : 0;
  return number;
}

// What lines of the file, or of a part of it, are about.
struct Line_facts
{
  std::size_t highest_vertex = 0, line_of_highest_vertex = 0; // of faces and lines, and the first line with it
  std::size_t unknown_lines = 0, first_unknown_line = 0;      // that begin with no keyword
  std::string first_unknown_keyword;
};

// Reads the file, or the part of it that has so many vertices before it.
Polygon_soup read_lines(Text_input& input, std::size_t number_before, Line_facts& facts)
{
  Polygon_soup soup;
  std::vector<std::size_t> corners;
  while(next_joined_line(input))
  {
    const std::string_view keyword = input.word_of_line();
    if(keyword == "v")
      soup.points.push_back(point_of([&] { return input.number<double>(input.word_of_line()); }));
    else if(keyword == "f" || keyword == "fo" || keyword == "l")
    {
      const std::size_t highest = read_corners(input, number_before + soup.points.size(), corners);
      if(highest > facts.highest_vertex)
        std::tie(facts.highest_vertex, facts.line_of_highest_vertex) = std::make_pair(highest, input.line_number());
      if(keyword == "l" && corners.size() < 2)
        input.fail("a line has fewer than two vertices");
      for(std::size_t i = 1; keyword == "l" && i < corners.size(); ++i)
        soup.edges.push_back({corner(corners[i - 1]), corner(corners[i])});
      if(keyword != "l")
        soup.polygons.add(corners);
    }
    else if(is_geometry_not_read(keyword))
      input.fail(quote(keyword) + " is not read: a mesh has vertices, faces, and lines");
    else if(!keyword.empty() && !is_skipped_keyword(keyword) && facts.unknown_lines++ == 0)
    {
      facts.first_unknown_line = input.line_number();
      facts.first_unknown_keyword = keyword;
    }
  }
  return soup;
}

// Throws Input_error for vertices that do not exist.
void add_facts(const std::string& path, const std::vector<Line_facts>& parts, Polygon_soup& soup)
{
  Line_facts all;
  for(const Line_facts& part : parts)
  {
    if(part.highest_vertex > all.highest_vertex)
      std::tie(all.highest_vertex, all.line_of_highest_vertex) =
        std::tie(part.highest_vertex, part.line_of_highest_vertex);
    if(all.unknown_lines == 0)
      std::tie(all.first_unknown_line, all.first_unknown_keyword) =
        std::tie(part.first_unknown_line, part.first_unknown_keyword);
    all.unknown_lines += part.unknown_lines;
  }
  if(all.highest_vertex >= soup.points.size())
    throw Input_error(path, all.line_of_highest_vertex, "there is no vertex " + std::to_string(all.highest_vertex + 1));
  if(all.unknown_lines > 0)
    soup.notes.push_back(std::to_string(all.unknown_lines)
                         + (all.unknown_lines == 1 ? " line of the file begins" : " lines of the file begin")
                         + " with no keyword of OBJ, the first one, line " + std::to_string(all.first_unknown_line)
                         + ", with " + quote(all.first_unknown_keyword));
}

} // namespace

Polygon_soup read_obj(const std::string& path)
{
  const File_contents file(path);
  const Text_blocks blocks(Text_input(path, file.text()));
  const std::vector<std::size_t> before = blocks.count_before(count_points);
  std::vector<Polygon_soup> parts(blocks.size());
  std::vector<Line_facts> facts(blocks.size());
  run_tasks(blocks.size(), [&](std::size_t i) {
    Text_input block = blocks.input(i);
    parts[i] = read_lines(block, before[i], facts[i]);
  });
  Polygon_soup soup = join(std::move(parts));
  if(soup.points.empty() || (soup.polygons.size() == 0 && soup.edges.empty()))
    throw Input_error(path, blocks.number_of_lines(), "the file ends without a face, and point clouds are not read");
  add_facts(path, facts, soup);
  return soup;
}

namespace {
// Vertices have numbers of their own in a TS file.
class Numbered_vertices
{
public:
  explicit Numbered_vertices(Text_input& input) : input_(input) {}

  // Reads the number and the coordinates of a vertex.
  Point read_point()
  {
    const auto number = input_.number<long long>(input_.word_of_line());
    if(!positions_.emplace(number, positions_.size()).second)
      input_.fail("there is a vertex " + std::to_string(number) + " before");
    return point_of([&] { return input_.number<double>(input_.word_of_line()); });
  }

  // Reads the numbers of the vertices of a triangle.
  void read_triangle(Polygons& polygons)
  {
    for(int corner = 0; corner < 3; ++corner)
    {
      const auto number = input_.number<long long>(input_.word_of_line());
      const auto position = positions_.find(number);
      if(position == positions_.end())
        input_.fail("there is no vertex " + std::to_string(number) + " before");
      polygons.add_corner(position->second);
    }
    polygons.end_polygon();
  }

private:
  Text_input& input_;
  std::unordered_map<long long, std::size_t> positions_;
};

} // namespace

Polygon_soup read_ts(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  while(input.next_word_of_line() != "TFACE")
    if(!input.next_line())
      input.fail("the file ends, and has no line TFACE");
  Polygon_soup soup;
  Numbered_vertices vertices(input);
  bool has_end = false;
  while(input.next_line())
  {
    const std::string_view keyword = input.word_of_line();
    if(keyword == "VRTX" || keyword == "PVRTX")
      soup.points.push_back(vertices.read_point());
    else if(keyword == "TRGL")
      vertices.read_triangle(soup.polygons);
    else if(keyword == "ATOM" || keyword == "PATOM")
      input.fail("vertices that are others again are not read");
    else if(keyword == "SEG" || keyword == "TETRA")
      input.fail(quote(keyword) + " is not read: cells are triangles, TRGL");
    has_end = has_end || keyword == "END";
  }
  if(!has_end)
    input.fail("the file ends, and has no line END");
  return soup;
}

namespace {
template <class Number>
Number next_number(Text_input& input)
{
  return input.number<Number>(next_word_of_file(input));
}

// Vertices are numbered from 1.
Corner next_corner(Text_input& input)
{
  const auto number = next_number<std::size_t>(input);
  if(number == 0)
    input.fail("there is no vertex 0: the first one has number 1");
  return corner(number - 1);
}

// Each simplex ends with a label.
template <std::size_t n>
std::array<Corner, n> next_simplex(Text_input& input)
{
  std::array<Corner, n> simplex;
  for(Corner& v : simplex)
    v = next_corner(input);
  next_number<long long>(input);
  return simplex;
}

template <std::size_t n>
void add_polygon(Text_input& input, Polygons& polygons)
{
  polygons.add(next_simplex<n>(input));
}

Point next_point(Text_input& input)
{
  const Point point = point_of([&] { return next_number<double>(input); });
  next_number<long long>(input);
  return point;
}

// How many numbers each entry has of a section that says nothing of the complex; 0 if there is no such section.
std::size_t numbers_per_entry(std::string_view section)
{
  constexpr std::array<std::string_view, 7> one = {
    "Corners",           "Ridges", "RequiredVertices", "RequiredEdges", "RequiredTriangles", "RequiredQuadrilaterals",
    "RequiredTetrahedra"};
  constexpr std::array<std::string_view, 2> two = {"NormalAtVertices", "TangentAtVertices"};
  constexpr std::array<std::string_view, 5> three = {"Normals", "NormalAtTriangleVertices",
                                                     "NormalAtQuadrilateralVertices", "Tangents", "TangentAtEdges"};
  return is_one_of(one, section) ? 1 : is_one_of(two, section) ? 2 : is_one_of(three, section) ? 3 : 0;
}

void read_section(Text_input& input, const std::string& section, Polygon_soup& soup)
{
  const std::size_t numbers = numbers_per_entry(section);
  const auto has_cells = [&] {
    return section == "Vertices" || section == "Edges" || section == "Triangles" || section == "Quadrilaterals"
        || section == "Tetrahedra";
  };
  if(numbers == 0 && !has_cells())
    input.fail(quote(section)
               + " is not a section that is read: cells are edges, triangles, quadrilaterals, or tetrahedra");
  for(auto size = next_number<std::size_t>(input); size > 0; --size)
  {
    if(section == "Vertices")
      soup.points.push_back(next_point(input));
    else if(section == "Edges")
      soup.edges.push_back(next_simplex<2>(input));
    else if(section == "Triangles")
      add_polygon<3>(input, soup.polygons);
    else if(section == "Quadrilaterals")
      add_polygon<4>(input, soup.polygons);
    else if(section == "Tetrahedra")
      soup.tetrahedra.push_back(next_simplex<4>(input));
    else
      for(std::size_t i = 0; i < numbers; ++i)
        next_number<double>(input);
  }
}

} // namespace

Polygon_soup read_medit(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  if(next_word_of_file(input) != "MeshVersionFormatted")
    input.fail("the file does not begin as a MESH file of Medit");
  next_number<int>(input);
  if(next_word_of_file(input) != "Dimension" || next_number<int>(input) != 3)
    input.fail("the mesh is not one of dimension 3");
  Polygon_soup soup;
  std::string section(next_word_of_file(input)); // none at the end of a file without End, which some programs leave out
  for(; !section.empty() && section != "End"; section = next_word_of_file(input))
    read_section(input, section, soup);
  return soup;
}

} // namespace reeb_graph_program
