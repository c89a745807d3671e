// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/mesh_input.h"

#include "input/assemble_surface.h"
#include "input/input_error.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"
#include "input/triangulate_faces.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace reeb_graph_program {
namespace {
Polygon_soup read_soup(const std::string& path, const std::string& vertex_property)
{
  if(!std::ifstream(path) || !std::filesystem::is_regular_file(path))
    throw Input_error(path, "the file cannot be read");
  const std::string extension = lower_case_extension(path);
  if(extension == ".ply")
    return read_ply(path, vertex_property);
  if(!vertex_property.empty())
    throw Input_error(path, "there is no field " + quote(vertex_property)
                              + ": it is x, y, z, height, harmonic, poisson, geodesic, unit-gradient, or the name of a "
                                "property of the vertices of a PLY file");
  if(extension == ".off")
    return read_off(path);
  if(extension == ".obj")
    return read_obj(path);
  if(extension == ".stl")
    return read_stl(path);
  if(extension == ".ts")
    return read_ts(path);
  throw Input_error(path, "the extension of a mesh file is .off, .obj, .ply, .stl, or .ts");
}

void check_points(const std::string& path, const std::vector<Point>& points)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()) || !std::isfinite(points[i].z()))
      throw Input_error(path, "vertex " + std::to_string(i) + " has a coordinate that is not a finite number");
}

// The first vertex at two corners, none if there is none.
std::optional<Corner> find_repeated_vertex(Polygons::Polygon polygon, std::vector<Corner>& sorted)
{
  if(polygon.size() == 3)
  {
    const Corner* const v = polygon.begin();
    return v[0] == v[1] || v[0] == v[2] ? std::make_optional(v[0])
         : v[1] == v[2]                 ? std::make_optional(v[1])
                                        : std::nullopt;
  }
  sorted.assign(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  return repeated == sorted.end() ? std::nullopt : std::make_optional(*repeated);
}

void check_polygons(const std::string& path, const Polygon_soup& soup, bool are_faces_triangulated)
{
  const auto fail = [&](std::size_t i, const std::string& message) {
    throw Input_error(path, "face " + std::to_string(i) + message);
  };
  std::vector<Corner> sorted;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const Polygons::Polygon polygon = soup.polygons[i];
    for(const Corner v : polygon)
      if(v >= soup.points.size())
        fail(i, " has a vertex that does not exist");
    if(polygon.size() < 3)
      fail(i, " has fewer than three vertices");
    if(polygon.size() > 3 && !are_faces_triangulated)
      fail(i, " has " + std::to_string(polygon.size())
                + " vertices and is not a triangle; --triangulate cuts such faces into triangles");
    if(const auto repeated = find_repeated_vertex(polygon, sorted))
      fail(i, " has vertex " + std::to_string(*repeated) + " at two of its corners");
  }
}

// Notes the first place at which CGAL cannot orient the faces without cutting the surface open. CGAL copies the
// visitor, hence the pointer.
struct Obstacle_finder : PMP::Default_orientation_visitor
{
  explicit Obstacle_finder(std::optional<std::string>& obstacle) : obstacle(&obstacle) {}

  void non_manifold_edge(std::size_t u, std::size_t v, std::size_t number_of_faces)
  {
    if(!*obstacle)
      *obstacle = "the edge between the vertices " + std::to_string(u) + " and " + std::to_string(v) + " has "
                + std::to_string(number_of_faces) + " faces";
  }
  void duplicated_vertex(std::size_t v, std::size_t)
  {
    if(!*obstacle)
      *obstacle = "the surface is not manifold, or not orientable, at vertex " + std::to_string(v);
  }

  std::optional<std::string>* obstacle;
};

// Adds one face after the other, which takes faces whose only gaps at a vertex are borders.
bool assemble_face_by_face(const Polygon_soup& soup, Surface& surface)
{
  surface.clear();
  for(const Point& point : soup.points)
    surface.add_vertex(point);
  std::vector<Surface::Vertex_index> face;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    face.clear();
    for(const Corner v : soup.polygons[i])
      face.emplace_back(v);
    if(CGAL::Euler::add_face(face, surface) == Surface::null_face())
      return false;
  }
  return true;
}

bool assemble(const Polygon_soup& soup, Surface& surface)
{
  return assemble_surface(soup, surface) || assemble_face_by_face(soup, surface);
}

void orient(const std::string& path, Polygon_soup& soup)
{
  std::vector<std::vector<std::size_t>> polygons;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    polygons.emplace_back(soup.polygons[i].begin(), soup.polygons[i].end());
  std::optional<std::string> obstacle;
  if(!PMP::orient_polygon_soup(soup.points, polygons, CGAL::parameters::visitor(Obstacle_finder(obstacle))))
    throw Input_error(path, obstacle.value_or("the surface is not manifold, or not orientable"));
  soup.polygons = Polygons();
  for(const std::vector<std::size_t>& polygon : polygons)
  {
    for(const std::size_t v : polygon)
      soup.polygons.add_corner(v);
    soup.polygons.end_polygon();
  }
}

void triangulate(const std::string& path, Surface& surface)
{
  triangulate_faces(surface);
  for(const Surface::Face_index f : surface.faces())
    if(surface.degree(f) != 3)
      throw Input_error(path, "face " + std::to_string(f.idx()) + " cannot be cut into triangles");
}

} // namespace

bool is_ply_file(const std::string& path) { return lower_case_extension(path) == ".ply"; }

Surface read_surface(const std::string& path, bool are_faces_triangulated, const std::string& vertex_property)
{
  Polygon_soup soup = read_soup(path, vertex_property);
  check_points(path, soup.points);
  check_polygons(path, soup, are_faces_triangulated);
  Surface surface;
  if(!assemble(soup, surface))
  {
    orient(path, soup);
    if(!assemble(soup, surface))
      throw Input_error(path, "the faces do not form a manifold surface");
  }
  if(!vertex_property.empty())
  {
    const Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = soup.scalars[v];
  }
  if(are_faces_triangulated)
    triangulate(path, surface);
  return surface;
}

} // namespace reeb_graph_program
