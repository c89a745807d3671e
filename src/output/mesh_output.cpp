// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/mesh_output.h"

#include "base/surface.h"
#include "input/mesh_formats.h"
#include "output/output_file.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr int all_digits_of_meshes = std::numeric_limits<double>::max_digits10;

typedef Surface::Property_map<Surface::Vertex_index, CGAL::IO::Color> Vertex_color_map;
typedef Surface::Property_map<Surface::Face_index, CGAL::IO::Color> Face_color_map;

// From dark blue over green to yellow as `t` goes from 0 to 1: viridis, which eyes that mix up colours see as steps of
// brightness.
CGAL::IO::Color colour(double t)
{
  constexpr std::size_t last = 9;
  constexpr std::array<std::array<double, 3>, last + 1> stops = {{{68, 1, 84},
                                                                  {72, 40, 120},
                                                                  {62, 74, 137},
                                                                  {49, 104, 142},
                                                                  {38, 130, 142},
                                                                  {31, 158, 137},
                                                                  {53, 183, 121},
                                                                  {110, 206, 88},
                                                                  {181, 222, 43},
                                                                  {253, 231, 37}}};
  const std::size_t i = (std::min)(static_cast<std::size_t>(last * t), last - 1);
  const double u = last * t - static_cast<double>(i);
  std::array<unsigned char, 3> rgb;
  for(std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<unsigned char>(std::lround((1 - u) * stops[i][c] + u * stops[i + 1][c]));
  return CGAL::IO::Color(rgb[0], rgb[1], rgb[2]);
}

// The place of a value between the lowest and the highest finite one, in the middle if they are the same.
class Colour_scale
{
public:
  Colour_scale(const Surface& surface, Scalar_map scalar_map)
  {
    for(const Surface::Vertex_index v : surface.vertices())
    {
      if(!std::isfinite(scalar_map[v]))
        continue;
      lowest_ = (std::min)(lowest_, scalar_map[v]);
      highest_ = (std::max)(highest_, scalar_map[v]);
    }
  }

  CGAL::IO::Color operator()(double value) const
  {
    if(!(lowest_ < highest_))
      return colour(0.5);
    return colour(std::clamp((value / 2 - lowest_ / 2) / (highest_ / 2 - lowest_ / 2), 0., 1.)); // finite differences
  }

private:
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -std::numeric_limits<double>::infinity();
};

// Consecutive patches get colours that lie far from each other: the hue turns by the golden angle.
CGAL::IO::Color colour_of_patch(int patch)
{
  const double turn = patch * 0.6180339887498949;
  const double hue = 6 * (turn - std::floor(turn));
  const auto channel = [&](double shift) {
    const double position = std::fmod(hue + shift, 6.);
    const double level = std::clamp(std::abs(position - 3) - 1, 0., 1.);
    return static_cast<unsigned char>(std::lround(70 + 165 * level));
  };
  return CGAL::IO::Color(channel(0), channel(4), channel(2));
}

Vertex_color_map add_vertex_colours(Surface& surface, Scalar_map scalar_map)
{
  Vertex_color_map colour_map = surface.add_property_map<Surface::Vertex_index, CGAL::IO::Color>("v:color").first;
  const Colour_scale colour_of_value(surface, scalar_map);
  for(const Surface::Vertex_index v : surface.vertices())
    colour_map[v] = colour_of_value(scalar_map[v]);
  return colour_map;
}

template <class Patches>
Face_color_map add_face_colours(Surface& surface, const Patches& patches)
{
  Face_color_map colour_map = surface.add_property_map<Surface::Face_index, CGAL::IO::Color>("f:color").first;
  for(const Surface::Face_index f : surface.faces())
    colour_map[f] = colour_of_patch(patches[f]);
  return colour_map;
}

void write_binary_ply(const std::filesystem::path& path, const Surface& surface)
{
  write_file(path, [&](std::ostream& stream) {
    CGAL::IO::set_binary_mode(stream);
    CGAL::IO::write_PLY(stream, surface);
  });
}

// Adds a property map to the surface. Returns its numbers, under the name behind v: or f:.
template <class Range, class NumberOf>
CGAL::Reeb_graph::Attribute add_column(Surface& surface,
                                       const Range& range,
                                       const std::string& name,
                                       NumberOf number_of)
{
  typedef std::decay_t<decltype(*range.begin())> Key;
  typedef std::decay_t<decltype(number_of(Key()))> Number;
  const auto map = surface.add_property_map<Key, Number>(name).first;
  std::vector<std::conditional_t<std::is_same_v<Number, double>, double, std::int64_t>> numbers;
  for(const Key key : range)
    numbers.push_back(map[key] = number_of(key));
  return {name.substr(2), std::move(numbers)};
}

template <class Vertices>
void add_unconnected_face(const Vertices& vertices, Surface& surface)
{
  const Surface::Face_index f = surface.add_face();
  std::vector<Surface::Halfedge_index> halfedges;
  Surface::Vertex_index previous(*(vertices.end() - 1));
  for(const auto number : vertices)
  {
    const Surface::Vertex_index v(number);
    halfedges.push_back(surface.add_edge(previous, v));
    surface.set_face(halfedges.back(), f);
    previous = v;
  }
  for(std::size_t i = 0; i < halfedges.size(); ++i)
    surface.set_next(halfedges[i], halfedges[(i + 1) % halfedges.size()]);
  surface.set_halfedge(f, halfedges.front()); // leads to the first vertex
}

Surface unconnected_surface(const Mesh& mesh)
{
  Surface surface = mesh.surface;
  for(const auto& triangle : mesh.complex->triangles)
    add_unconnected_face(triangle, surface);
  return surface;
}

const std::vector<std::string> formats_of_meshes = {".off", ".ply", ".obj", ".stl", ".vtp"};

// The numbers of the vertices that files have.
std::vector<CGAL::Reeb_graph::Attribute> vertex_attributes(const Surface& surface)
{
  std::vector<CGAL::Reeb_graph::Attribute> attributes;
  visit_vertex_properties(surface, [&](const std::string& name, const auto& map) {
    typedef typename std::decay_t<decltype(map)>::value_type Number;
    if constexpr(std::is_floating_point_v<Number>)
      attributes.push_back({name, std::vector<double>(map.begin(), map.end())});
    else
      attributes.push_back({name, std::vector<std::int64_t>(map.begin(), map.end())});
  });
  return attributes;
}

void write_stl(const std::filesystem::path& path, const Surface& surface)
{
  for(const Surface::Face_index f : surface.faces())
    if(surface.degree(f) != 3)
      throw std::runtime_error(path.string() + ": STL has triangles only, and face " + std::to_string(f.idx())
                               + " is not one: --triangulate cuts faces into triangles");
  write_file(path, [&](std::ostream& stream) {
    CGAL::IO::set_ascii_mode(stream); // binary STL has half of the digits
    CGAL::IO::write_STL(stream, surface, CGAL::parameters::stream_precision(all_digits_of_meshes));
  });
}

// STL has no vertices: readers make those of the corners, and points that coincide one.
void note_lost_vertices(const std::filesystem::path& path, const Surface& surface, Notes& notes)
{
  std::vector<Surface::Vertex_index> vertices;
  for(const Surface::Halfedge_index h : surface.halfedges())
    vertices.push_back(surface.target(h));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Point> points;
  for(const Surface::Vertex_index v : vertices)
    points.push_back(surface.point(v));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if(vertices.size() < surface.number_of_vertices())
    notes.push_back(path.string() + ": isolated vertices are left out, as STL has triangles only: "
                    + std::to_string(surface.number_of_vertices() - vertices.size()));
  if(points.size() < vertices.size())
    notes.push_back(path.string() + ": vertices at the place of others are one with them in STL: "
                    + std::to_string(vertices.size() - points.size()));
}

// What the format has no room for.
void note_lost_results(const std::filesystem::path& path,
                       const std::string& format,
                       const Mesh_results& results,
                       Notes& notes)
{
  std::vector<std::string> things = {"the field", "arcs and nodes of vertices"};
  if(results.patch_map)
    things.emplace_back("patches");
  if(results.band_map)
    things.emplace_back("bands");
  if(results.original_map)
    things.emplace_back("numbers of original vertices");
  if(format != ".off")
    things.emplace_back("colors");
  note_left_out(path, things, notes);
}

} // namespace

void check_mesh_format(const std::filesystem::path& path) { ending_of(path, "a mesh", formats_of_meshes); }

Surface unconnected_surface(const std::vector<Point>& points, const Polygons& polygons)
{
  Surface surface;
  for(const Point& point : points)
    surface.add_vertex(point);
  for(std::size_t i = 0; i < polygons.size(); ++i)
    add_unconnected_face(polygons[i], surface);
  return surface;
}

bool has_room_for_numbers(const std::filesystem::path& path)
{
  const std::string format = ending_of(path, "a mesh", formats_of_meshes);
  return format == ".ply" || format == ".vtp";
}

void note_left_out(const std::filesystem::path& path, const std::vector<std::string>& things, Notes& notes)
{
  std::string list;
  for(const std::string& thing : things)
    list += (list.empty() ? "" : &thing == &things.back() ? " and " : ", ") + thing;
  const bool is_one = things.size() == 1 && (things.front() + ' ').find("s ") == std::string::npos;
  if(!things.empty())
    notes.push_back(path.string() + ": " + list + (is_one ? " is" : " are") + " left out"
                    + (has_room_for_numbers(path) ? "" : ", for which .ply and .vtp have room"));
}

void note_lost_parts(const std::filesystem::path& path, const std::string& input, Notes& notes)
{
  for(const std::string& part : parts_not_kept(input))
    notes.push_back(path.string() + ": " + part + " of the input are left out");
}

std::vector<Any_vertex_property> properties_to_keep(const std::string& input,
                                                    const std::vector<std::string>& outputs,
                                                    Surface& surface,
                                                    Notes& notes)
{
  for(const std::string& output : outputs)
  {
    note_left_out(output, fields_not_kept(input, has_room_for_numbers(output)), notes);
    note_lost_parts(output, input, notes);
  }
  const bool is_any_kept = std::any_of(outputs.begin(), outputs.end(), has_room_for_numbers);
  return is_any_kept ? read_vertex_properties(input, surface) : std::vector<Any_vertex_property>();
}

void write_surface(const std::filesystem::path& path, const Surface& surface, Notes& notes)
{
  const std::string format = ending_of(path, "a mesh", formats_of_meshes);
  if(format == ".ply")
    return write_binary_ply(path, surface);
  if(format == ".stl")
  {
    note_lost_vertices(path, surface, notes);
    return write_stl(path, surface);
  }
  write_file(path, [&](std::ostream& stream) {
    const auto np = CGAL::parameters::stream_precision(all_digits_of_meshes);
    if(format == ".vtp")
      CGAL::Reeb_graph::write_mesh_vtp(stream, surface,
                                       CGAL::parameters::vertex_attributes(vertex_attributes(surface)));
    else if(format == ".obj")
      CGAL::IO::write_OBJ(stream, surface, np);
    else
      CGAL::IO::write_OFF(stream, surface, np);
  });
}

void write_scalars(const std::filesystem::path& path, const Surface& surface, Scalar_map scalar_map)
{
  std::vector<double> scalars;
  for(const Surface::Vertex_index v : surface.vertices())
    scalars.push_back(scalar_map[v]);
  write_numbers(path, scalars);
}

void check_numbers_format(const std::filesystem::path& path)
{
  static const std::vector<std::string> meshes = {".off",  ".ply", ".obj", ".stl", ".ts",
                                                  ".mesh", ".vtk", ".vtu", ".vtp"};
  if(std::find(meshes.begin(), meshes.end(), path.extension()) != meshes.end())
    throw std::runtime_error(path.string()
                             + ": this is written as one number per line, or as .npy; --mesh-out of compute "
                               "writes meshes with fields");
}

void write_mesh(const std::filesystem::path& path, const Surface& surface, const Mesh_results& results, Notes& notes)
{
  namespace parameters = CGAL::parameters;
  Surface mesh = surface;
  mesh.remove_all_property_maps(); // Some may have the names of the results.
  const auto place = [&, number = static_cast<int>(results.number_of_nodes)](Surface::Vertex_index v) {
    return static_cast<int>(results.places[v.idx()]) - number; // negative at nodes
  };
  const auto add = [&](auto& attributes, const auto& range, const std::string& name, const auto& number_of) {
    attributes.push_back(add_column(mesh, range, name, number_of));
  };
  const auto add_map = [&](auto& attributes, const auto& range, const std::string& name, const auto& map) {
    if(map)
      add(attributes, range, name, [&](auto key) { return static_cast<int>((*map)[key]); });
  };
  std::vector<CGAL::Reeb_graph::Attribute> vertex_attributes, face_attributes;
  add(vertex_attributes, mesh.vertices(), "v:scalar", [&](auto v) { return results.scalar_map[v]; });
  const Vertex_color_map vertex_colours = add_vertex_colours(mesh, results.scalar_map);
  add(vertex_attributes, mesh.vertices(), "v:arc", [&](auto v) { return std::max(place(v), -1); });
  add(vertex_attributes, mesh.vertices(), "v:node",
      [&](auto v) { return place(v) < 0 ? static_cast<int>(results.places[v.idx()]) : -1; });
  add_map(vertex_attributes, mesh.vertices(), "v:original", results.original_map);
  add_map(face_attributes, mesh.faces(), "f:patch", results.patch_map);
  Face_color_map face_colours;
  if(results.patch_map)
    face_colours = add_face_colours(mesh, *results.patch_map);
  add_map(face_attributes, mesh.faces(), "f:band", results.band_map);
  // of a pipe, a device, or standard output the first one
  const std::string format = ending_of(path, "a mesh with results", {".ply", ".vtp", ".off", ".obj", ".stl"});
  if(format == ".off" || format == ".obj" || format == ".stl")
  {
    note_lost_results(path, format, results, notes);
    return write_surface(path, mesh, notes);
  }
  if(format == ".ply")
    return write_binary_ply(path, mesh);
  vertex_attributes.front().name = "value";
  const auto np = parameters::vertex_attributes(vertex_attributes);
  write_file(path, [&](std::ostream& stream) {
    if(results.patch_map)
      CGAL::Reeb_graph::write_mesh_vtp(
        stream, mesh,
        np.face_attributes(face_attributes).vertex_color_map(vertex_colours).face_color_map(face_colours));
    else
      CGAL::Reeb_graph::write_mesh_vtp(stream, mesh, np.vertex_color_map(vertex_colours));
  });
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const Mesh_results& results, Notes& notes)
{
  if(!mesh.complex)
    return write_mesh(path, mesh.surface, results, notes);
  if(!mesh.complex->edges.empty())
    notes.push_back(path.string() + ": edges of no face are left out, " + std::to_string(mesh.complex->edges.size()));
  write_mesh(path, unconnected_surface(mesh), results, notes);
}

void write_coloured_surface(const std::filesystem::path& path, Surface surface, Scalar_map scalar_map)
{
  add_vertex_colours(surface, scalar_map);
  write_binary_ply(path, surface);
}

void check_format_with_numbers(const std::filesystem::path& path)
{
  ending_of(path, "a mesh with branches", {".ply", ".vtp"});
}

void write_surface_with_numbers(const std::filesystem::path& path,
                                Surface surface,
                                const std::vector<Face_numbers>& columns)
{
  const bool is_ply = ending_of(path, "a mesh with branches", {".ply", ".vtp"}) == ".ply";
  surface.remove_all_property_maps();
  std::vector<CGAL::Reeb_graph::Attribute> attributes;
  Face_color_map face_colours;
  for(const Face_numbers& column : columns)
  {
    attributes.push_back(add_column(surface, surface.faces(), "f:" + column.first,
                                    [&](Surface::Face_index f) { return column.second[f]; }));
    if(attributes.size() == 1)
      face_colours = add_face_colours(surface, column.second);
  }
  if(is_ply)
    return write_binary_ply(path, surface);
  write_file(path, [&](std::ostream& stream) {
    CGAL::Reeb_graph::write_mesh_vtp(stream, surface,
                                     CGAL::parameters::face_attributes(attributes).face_color_map(face_colours));
  });
}

void write_pieces(const std::filesystem::path& folder, const Surface& surface, const std::vector<std::size_t>& pieces)
{
  Output_group files;
  make_folder(folder);
  std::vector<std::vector<Surface::Face_index>> faces_of_pieces;
  for(const Surface::Face_index f : surface.faces())
  {
    faces_of_pieces.resize((std::max)(faces_of_pieces.size(), pieces[f] + 1));
    faces_of_pieces[pieces[f]].push_back(f);
  }
  std::set<std::string> names;
  std::vector<std::size_t> numbers(surface.number_of_vertices()), owners(numbers.size(), faces_of_pieces.size());
  for(std::size_t piece = 0; piece != faces_of_pieces.size(); ++piece)
  {
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 3>> triangles; // no mesh, as two fans of a piece may touch
    for(const Surface::Face_index f : faces_of_pieces[piece])
    {
      triangles.emplace_back();
      std::size_t i = 0;
      for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
      {
        if(std::exchange(owners[v], piece) != piece)
        {
          numbers[v] = points.size();
          points.push_back(surface.point(v));
        }
        triangles.back()[i++] = numbers[v];
      }
    }
    if(triangles.empty())
      continue;
    const std::string name = "piece_" + std::to_string(piece) + ".ply";
    names.insert(name);
    write_file(folder / name, [&](std::ostream& stream) {
      CGAL::IO::set_binary_mode(stream);
      CGAL::IO::write_PLY(stream, points, triangles);
    });
  }
  // Pieces of an earlier run would lie among the new ones.
  const std::regex name_of_piece("piece_[0-9]+[.]ply");
  for(const auto& entry : std::filesystem::directory_iterator(folder))
    if(const std::string name = entry.path().filename().string();
       names.count(name) == 0 && std::regex_match(name, name_of_piece))
      remove_file(entry.path());
  files.put_in_place();
}

void write_surface_with_patches(const std::filesystem::path& path, Surface surface, Patch_map patch_map, Notes& notes)
{
  const std::string format = ending_of(path, "a mesh", formats_of_meshes);
  if(format != ".vtp" && format != ".ply")
    return write_surface(path, surface, notes);
  const Face_color_map face_colours = add_face_colours(surface, patch_map);
  if(format == ".ply")
    return write_binary_ply(path, surface);
  const std::vector<CGAL::Reeb_graph::Attribute> patches = {
    {"patch", std::vector<std::int64_t>(patch_map.begin(), patch_map.end())}};
  write_file(path, [&](std::ostream& stream) {
    CGAL::Reeb_graph::write_mesh_vtp(stream, surface,
                                     CGAL::parameters::vertex_attributes(vertex_attributes(surface))
                                       .face_attributes(patches)
                                       .face_color_map(face_colours));
  });
}

} // namespace reeb_graph_program
