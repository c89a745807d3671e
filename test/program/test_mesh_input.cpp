// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "generated_surfaces/random_meshes.h"
#include "input/assemble_surface.h"
#include "input/text_blocks.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

// Surfaces are those that CGAL makes of one face after the other, and blocks of a text are the text.

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
} // namespace

int main()
{
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
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
