// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/assemble_surface.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"
#include "random_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

// Surfaces are those that CGAL makes of one face after the other, blocks of a text are the text, and
// binary STL files have each point once.

namespace {
using random_meshes::Random;
using namespace reeb_graph_program;

typedef std::vector<Corner> Face;

// Returns false if a face finds its place taken.
bool add_faces(const std::vector<Face>& faces, std::size_t number_of_vertices, Surface& surface)
{
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    surface.add_vertex(Point(double(v), 0, 0));
  for(const Face& face : faces)
    if(CGAL::Euler::add_face(std::vector<Surface::Vertex_index>(face.begin(), face.end()), surface)
       == Surface::null_face())
      return false;
  return true;
}

// Whether each vertex has at most one border halfedge: CGAL also adds faces whose fans meet in a vertex.
bool is_each_vertex_on_one_border(const Surface& surface)
{
  std::vector<int> number_of_gaps(surface.number_of_vertices());
  for(const Surface::Halfedge_index h : surface.halfedges())
    if(surface.is_border(h) && ++number_of_gaps[surface.target(h)] > 1)
      return false;
  return true;
}

bool are_equal(const Surface& a, const Surface& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_edges() != b.number_of_edges()
     || a.number_of_faces() != b.number_of_faces() || !a.is_valid(false))
    return false;
  for(const Surface::Vertex_index v : a.vertices())
    if(a.point(v) != b.point(v) || a.halfedge(v) != b.halfedge(v))
      return false;
  for(const Surface::Halfedge_index h : a.halfedges())
    if(a.target(h) != b.target(h) || a.next(h) != b.next(h) || a.prev(h) != b.prev(h) || a.face(h) != b.face(h))
      return false;
  for(const Surface::Face_index f : a.faces())
    if(a.halfedge(f) != b.halfedge(f))
      return false;
  return true;
}

// Faces of a random surface in any order that begin at any corner. Some are missing, some are turned, some become
// quadrangles, and some vertices may be one.
std::vector<Face> random_faces(Random& random, std::size_t& number_of_vertices)
{
  random_meshes::Combinatorial_mesh mesh =
    random_meshes::random_mesh(static_cast<random_meshes::Mesh_class>(random.below(6)), random);
  random.shuffle(mesh.triangles);
  number_of_vertices = mesh.number_of_vertices;
  const std::size_t missing = random.below(3), turned = random.below(20), identified = random.below(20);
  std::vector<Face> faces;
  for(const auto& triangle : mesh.triangles)
  {
    if(missing != 0 && random.below(8 * missing) == 0)
      continue;
    const std::size_t begin = random.below(3);
    Face face;
    for(std::size_t i = 0; i < 3; ++i)
      face.push_back(static_cast<Corner>(triangle[(begin + i) % 3]));
    if(turned == 0 && random.below(10) == 0)
      std::swap(face[0], face[1]);
    if(identified == 0)
      for(Corner& v : face)
        v = v + 1 == number_of_vertices ? 0 : v;
    if(face[0] != face[1] && face[0] != face[2] && face[1] != face[2])
      faces.push_back(face);
    if(!faces.empty() && random.below(50) == 0) // no triangle any more
      faces.back().push_back(static_cast<Corner>(number_of_vertices++));
  }
  return faces;
}

Polygon_soup soup_of(const std::vector<Face>& faces, std::size_t number_of_vertices)
{
  Polygon_soup soup;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    soup.points.emplace_back(double(v), 0, 0);
  for(const Face& face : faces)
  {
    for(const Corner v : face)
      soup.polygons.add_corner(v);
    soup.polygons.end_polygon();
  }
  return soup;
}

// Returns whether a surface was made.
bool check_surface(std::size_t seed, int& number_of_faults)
{
  Random random(seed);
  std::size_t number_of_vertices = 0;
  const std::vector<Face> faces = random_faces(random, number_of_vertices);
  Surface expected, surface;
  const bool is_expected = add_faces(faces, number_of_vertices, expected) && is_each_vertex_on_one_border(expected);
  const bool is_made = assemble_surface(soup_of(faces, number_of_vertices), surface);
  if(is_made != is_expected || (is_made && !are_equal(surface, expected)))
  {
    std::cerr << "seed " << seed << ": " << (is_made ? "another surface than expected\n" : "no surface is made\n");
    ++number_of_faults;
  }
  return is_made;
}

std::string random_text(Random& random)
{
  static const std::string characters = "ab \\\n\n\r#";
  std::string text;
  for(std::size_t i = random.below(400); i > 0; --i)
    text += characters[random.below(characters.size())];
  return text;
}

// The lines with their numbers, where those that a backslash joins are one.
std::string joined_lines(Text_input& input)
{
  std::string lines;
  while(input.next_line())
  {
    input.join_next_line();
    lines += std::to_string(input.line_number()) + ":" + std::string(input.line()) + '\n';
  }
  return lines;
}

void check_blocks(std::size_t seed, int& number_of_faults)
{
  Random random(seed);
  const std::string text = random_text(random);
  Text_input input("", text);
  const Text_blocks blocks(input, 1 + random.below(60));
  std::string lines;
  for(std::size_t i = 0; i < blocks.size(); ++i)
  {
    Text_input block = blocks.input(i);
    lines += joined_lines(block);
  }
  if(lines == joined_lines(input) && blocks.number_of_lines() == input.line_number())
    return;
  std::cerr << "seed " << seed << ": the blocks of a text are not the text\n";
  ++number_of_faults;
}

// Few enough points to be shared by corners, or so many that most corners are points of their own, zeros with signs.
std::vector<std::array<float, 3>> random_corners(Random& random)
{
  const std::size_t number_of_values = 1 + random.below(random.below(2) == 0 ? 8 : 100000);
  std::vector<std::array<float, 3>> corners(3 * random.below(1000));
  for(std::array<float, 3>& corner : corners)
    for(float& coordinate : corner)
      coordinate = (random.below(2) == 0 ? -1.f : 1.f) * static_cast<float>(random.below(number_of_values)) / 7;
  return corners;
}

// The bytes of a number, little-endian on any machine.
template <class Number>
std::string bytes_of(Number number)
{
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(&bytes[0], &number, sizeof(Number));
  if(is_machine_big_endian())
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

void write_binary_stl(const std::string& path, const std::vector<std::array<float, 3>>& corners)
{
  std::string bytes = std::string(80, ' ') + bytes_of(static_cast<std::uint32_t>(corners.size() / 3));
  for(std::size_t i = 0; i < corners.size(); ++i)
  {
    bytes.append(i % 3 == 0 ? 12 : 0, '\0'); // the normal
    for(const float number : corners[i])
      bytes += bytes_of(number);
    bytes.append(i % 3 == 2 ? 2 : 0, '\0');
  }
  std::ofstream(path, std::ios::binary) << bytes;
}

// The points of a binary STL file are those of its corners, each once, in the order in which they come first.
void check_stl(std::size_t seed, const std::string& path, int& number_of_faults)
{
  Random random(seed);
  const std::vector<std::array<float, 3>> corners = random_corners(random);
  write_binary_stl(path, corners);
  const Polygon_soup soup = read_stl(path);
  std::remove(path.c_str());
  std::map<std::array<float, 3>, std::size_t> vertices;
  bool is_right = soup.polygons.are_triangles() && soup.polygons.number_of_corners() == corners.size();
  for(std::size_t i = 0; is_right && i < corners.size(); ++i)
  {
    const std::size_t vertex = vertices.emplace(corners[i], vertices.size()).first->second;
    is_right = soup.polygons[i / 3].begin()[i % 3] == vertex && vertex < soup.points.size()
            && soup.points[vertex] == Point(corners[i][0], corners[i][1], corners[i][2]);
  }
  if(is_right && soup.points.size() == vertices.size())
    return;
  std::cerr << "seed " << seed << ": the mesh of a binary STL file is another one\n";
  ++number_of_faults;
}
} // namespace

int main(int argc, char* argv[])
{
  const std::string path = std::string(argc > 1 ? argv[1] : "mesh_input") + ".stl";
  int number_of_faults = 0, number_of_surfaces = 0;
  constexpr int number_of_seeds = 3000;
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
    number_of_surfaces += check_surface(seed, number_of_faults) ? 1 : 0;
  if(number_of_surfaces < number_of_seeds / 4 || number_of_surfaces == number_of_seeds)
  {
    std::cerr << number_of_surfaces << " surfaces of " << number_of_seeds << '\n';
    ++number_of_faults;
  }
  run_with_threads(4, [&] {
    for(std::size_t seed = 0; seed < 300; ++seed)
      check_blocks(seed, number_of_faults);
  });
  for(std::size_t seed = 0; seed < 300; ++seed)
    check_stl(seed, path, number_of_faults);
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
