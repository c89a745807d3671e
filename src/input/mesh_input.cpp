// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/surface.h"
#include "computation/analysis.h"
#include "input/assemble_surface.h"
#include "input/input_error.h"
#include "input/merge_points.h"
#include "input/mesh_formats.h"
#include "input/repair_soup.h"
#include "input/text_input.h"
#include "input/vtk_input.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
const char* const formats = "the extension of a mesh file is .off, .obj, .ply, .stl, .ts, .mesh, .vtk, .vtu, or .vtp; "
                            "faces and edges are read, and the tetrahedra of .mesh, .vtk, and .vtu, but neither voxels "
                            "nor point clouds";

bool is_freesurfer_surface(const std::string& path)
{
  std::array<char, 3> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return begin == std::array<char, 3>{'\xff', '\xff', '\xfe'};
}

std::string convert(const std::string& format, const std::string& tool)
{
  return format + " is not read: " + tool + " converts it; " + formats;
}

} // namespace

std::string refused_format(const std::string& path)
{
  static const std::string trimesh = "trimesh, as by trimesh.load(FILE, force='mesh').export('mesh.ply'),";
  static const std::string meshio = "'meshio convert FILE mesh.vtu'";
  static const std::string freesurfer = "FreeSurfer's 'mris_convert FILE mesh.vtk'";
  static const std::string cloud = convert("a point cloud", "CGAL's or MeshLab's Poisson reconstruction");
  static const std::string voxels = convert("an image of voxels", "ParaView's filter Contour");
  static const std::map<std::string, std::string> others = {{".xyz", cloud},
                                                            {".pcd", cloud},
                                                            {".las", cloud},
                                                            {".laz", cloud},
                                                            {".nii", voxels},
                                                            {".nrrd", voxels},
                                                            {".mha", voxels},
                                                            {".mhd", voxels},
                                                            {".tif", voxels},
                                                            {".glb", convert("glTF", trimesh)},
                                                            {".gltf", convert("glTF", trimesh)},
                                                            {".3mf", convert("3MF", trimesh)},
                                                            {".gii", convert("GIFTI", freesurfer)},
                                                            {".msh", convert("a mesh of Gmsh", meshio)},
                                                            {".vti", refused_vtk_type("ImageData")},
                                                            {".vtr", refused_vtk_type("RectilinearGrid")},
                                                            {".vts", refused_vtk_type("StructuredGrid")},
                                                            {".vtm", refused_vtk_type("vtkMultiBlockDataSet")},
                                                            {".pvtu", refused_vtk_type("PUnstructuredGrid")},
                                                            {".pvtp", refused_vtk_type("PPolyData")}};
  const auto found = others.find(lower_case_extension(path));
  if(found != others.end())
    return found->second;
  return is_freesurfer_surface(path) ? convert("a surface of FreeSurfer", freesurfer) : formats;
}

std::string refused_vtk_type(const std::string& type)
{
  const bool is_list = type.substr(0, 1) == "P" || type.substr(0, 3) == "vtk" || type == "Collection";
  return "data of VTK's type " + quote(type) + " are not read, but UnstructuredGrid and PolyData: "
       + (is_list ? "the file names others, which ParaView's filters Merge Blocks and Extract Surface join"
                  : vtk_way_out);
}

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
Polygon_soup read_soup(const std::string& path, const std::string& vertex_property)
{
  if(!is_standard_input(path) && (!std::ifstream(path) || !std::filesystem::is_regular_file(path)))
    throw unreadable_file(path);
  const std::string extension = lower_case_extension(path);
  if(extension == ".ply")
    return read_ply(path, vertex_property);
  if(extension == ".vtk" || extension == ".vtu" || extension == ".vtp")
    return read_vtk(path, vertex_property);
  if(!vertex_property.empty())
    throw Input_error(path, "there is no field " + quote(vertex_property)
                              + ": fields are x, y, z, height, harmonic, harmonic-between-borders, poisson, geodesic, "
                                "unit-gradient, and the properties of the vertices of PLY, VTK, VTU, and VTP files");
  if(extension == ".off")
    return read_off(path);
  if(extension == ".obj")
    return read_obj(path);
  if(extension == ".stl")
    return read_stl(path);
  if(extension == ".ts")
    return read_ts(path);
  if(extension == ".mesh")
    return read_medit(path);
  throw Input_error(path, refused_format(path));
}

void check_points(const std::string& path, const std::vector<Point>& points)
{
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()) || !std::isfinite(points[i].z()))
      throw Input_error(path, "vertex " + std::to_string(i) + " has a coordinate that is not a finite number");
}

void check_polygons(const std::string& path, const Polygon_soup& soup, bool are_faces_triangulated)
{
  const auto fail = [&](std::size_t i, const std::string& message) {
    throw Input_error(path, "face " + std::to_string(i) + message);
  };
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const Polygons::Polygon polygon = soup.polygons[i];
    for(const Corner v : polygon)
      if(v >= soup.points.size())
        fail(i, " has a vertex that does not exist");
    if(polygon.size() > 3 && !are_faces_triangulated)
      fail(i, " has " + std::to_string(polygon.size())
                + " vertices and is not a triangle; --triangulate cuts such faces into triangles");
  }
}

template <std::size_t n>
void check_simplices(const std::string& path,
                     const std::string& name,
                     const std::vector<std::array<Corner, n>>& simplices,
                     std::size_t number_of_vertices)
{
  for(std::size_t i = 0; i < simplices.size(); ++i)
  {
    std::array<Corner, n> sorted = simplices[i];
    std::sort(sorted.begin(), sorted.end());
    if(sorted.back() >= number_of_vertices)
      throw Input_error(path, name + " " + std::to_string(i) + " has a vertex that does not exist");
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if(repeated != sorted.end())
      throw Input_error(path, name + " " + std::to_string(i) + " has vertex " + std::to_string(*repeated)
                                + " at two of its corners");
  }
}

// Whether an edge of the soup is on none of its polygons.
bool has_free_edges(const Polygon_soup& soup)
{
  if(soup.edges.empty())
    return false;
  std::vector<std::pair<Corner, Corner>> sides;
  for_each_side(soup.polygons, [&](Corner u, Corner v) { sides.emplace_back(std::minmax(u, v)); });
  std::sort(sides.begin(), sides.end());
  return std::any_of(soup.edges.begin(), soup.edges.end(), [&](const std::array<Corner, 2>& edge) {
    return !std::binary_search(sides.begin(), sides.end(), std::pair<Corner, Corner>(std::minmax(edge[0], edge[1])));
  });
}

// Orients the faces consistently. Returns whether that can be done.
bool orient(Polygon_soup& soup)
{
  std::vector<std::vector<std::size_t>> polygons;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    polygons.emplace_back(soup.polygons[i].begin(), soup.polygons[i].end());
  if(!PMP::orient_polygon_soup(soup.points, polygons))
    return false;
  soup.polygons = Polygons();
  for(const std::vector<std::size_t>& polygon : polygons)
    soup.polygons.add(polygon);
  return true;
}

// Makes the surface of all that is in the soup. Returns false if there is none. The two sides of a polygon are a closed
// surface, but the same side twice is no matter of orientation.
bool make_surface(const Polygon_soup& soup, Surface& surface)
{
  if(!soup.tetrahedra.empty() || has_free_edges(soup))
    return false;
  if(assemble_surface(soup, surface))
    return true;
  if(find_duplicates(soup.polygons, true).number > 0)
    return false;
  Polygon_soup oriented;
  oriented.points = soup.points;
  oriented.polygons = soup.polygons;
  return orient(oriented) && assemble_surface(oriented, surface);
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Polygons& polygons)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(polygons.size());
  for(auto v = polygons.corners().begin(); v != polygons.corners().end(); v += 3)
    triangles.push_back({v[0], v[1], v[2]});
  return triangles;
}

// The vertices of a complex have their points, and nothing else.
void make_vertices(const std::vector<Point>& points, Surface& surface)
{
  surface.clear();
  surface.reserve(static_cast<Surface::size_type>(points.size()), 0, 0);
  for(const Point& point : points)
    surface.add_vertex(point);
}

// The vertices of edges with one face.
std::vector<Corner> border_points(const Polygon_soup& soup, const Mesh& mesh)
{
  std::vector<Corner> points;
  if(mesh.complex)
    return soup.tetrahedra.empty() ? border_points(soup.polygons) : points;
  for(const Surface::Vertex_index v : mesh.surface.vertices())
    if(!mesh.surface.is_isolated(v) && mesh.surface.is_border(v, false))
      points.push_back(v);
  return points;
}

// Which points are close to others now. Those that coincide have been merged where that makes a surface.
void look_over_repaired(const Mesh& mesh, Input_findings& findings)
{
  const Polygon_soup soup = soup_of(mesh.surface);
  const std::vector<Corner> border = border_points(soup, mesh);
  findings.close_points = count_close_points(soup.points, border);
  count_points_on_edges(soup, border, findings.close_points);
  if(!mesh.repair->given.is_surface())
    findings.close_points.coinciding = 0;
}

} // namespace

Mesh make_mesh(const Polygon_soup& soup, const Polygons* faces)
{
  Mesh mesh;
  if(!make_surface(soup, mesh.surface))
  {
    const Duplicates duplicates = find_duplicates(faces == nullptr ? soup.polygons : *faces, false);
    mesh.complex =
      Complex{soup.edges, triangles_of(soup.polygons), soup.tetrahedra, duplicates.number, duplicates.first};
    remove_faces_of_cells(*mesh.complex);
    make_vertices(soup.points, mesh.surface);
  }
  return mesh;
}

bool is_ply_file(const std::string& path) { return lower_case_extension(path) == ".ply"; }

Polygon_soup read_checked_soup(const std::string& path,
                               bool are_faces_triangulated,
                               const std::string& vertex_property,
                               Input_findings& findings)
{
  Polygon_soup soup = read_soup(path, vertex_property);
  check_points(path, soup.points);
  check_polygons(path, soup, are_faces_triangulated);
  leave_out_degenerate_faces(soup.polygons, findings);
  check_simplices(path, "edge", soup.edges, soup.points.size());
  check_simplices(path, "tetrahedron", soup.tetrahedra, soup.points.size());
  return soup;
}

void look_over_points(const Polygon_soup& soup, const std::vector<Corner>& border_points, Input_findings& findings)
{
  findings.close_points = count_close_points(soup.points, border_points);
  count_points_on_edges(soup, border_points, findings.close_points);
  std::vector<char> is_isolated(soup.points.size(), 1);
  const auto reach = [&](const auto& vertices) {
    for(const Corner v : vertices)
      is_isolated[v] = 0;
  };
  reach(soup.polygons.corners());
  std::for_each(soup.edges.begin(), soup.edges.end(), reach);
  std::for_each(soup.tetrahedra.begin(), soup.tetrahedra.end(), reach);
  findings.points = soup.points.size();
  findings.isolated_points = static_cast<std::size_t>(std::count(is_isolated.begin(), is_isolated.end(), 1));
}

void triangulate_faces(Polygon_soup& soup, const std::string& path, const Input_findings& findings)
{
  if(const auto number = triangulate_faces(soup))
    throw Input_error(path, "face " + std::to_string(number_in_file(*number, findings))
                              + " cannot be cut into triangles: it has no area");
}

bool is_to_be_repaired(const Polygon_soup& soup, const Mesh& mesh, const Repair_options& repair)
{
  if(!mesh.complex)
    return repair.least_share > 0;
  return repair.is_split && mesh.complex->tetrahedra.empty() && soup.polygons.size() > 0;
}

void repair_mesh(Polygon_soup soup, Repair_options repair, Mesh& mesh)
{
  if(count_soup(soup.polygons, soup.points.size()).is_surface())
  {
    const double least_share = repair.least_share;
    repair = Repair_options();
    repair.least_share = least_share;
  }
  repair.are_faces_triangulated = true;
  Polygon_soup whole;
  whole.points = soup.points;
  const Repair_result result = repair_soup(soup, repair);
  std::vector<std::size_t> numbers(soup.points.size());
  std::vector<std::array<std::uint32_t, 2>> origins;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const std::size_t old = result.old_vertices[v];
    numbers[v] = result.new_vertices[old] == v ? old : whole.points.size();
    if(numbers[v] == old)
      continue;
    whole.points.push_back(soup.points[v]);
    origins.push_back({static_cast<std::uint32_t>(old), static_cast<std::uint32_t>(result.other_ends[v])});
  }
  std::vector<std::size_t> corners;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    corners.clear();
    for(const Corner v : soup.polygons[i])
      corners.push_back(numbers[v]);
    whole.polygons.add(corners);
  }
  if(!assemble_surface(whole, mesh.surface))
    throw std::runtime_error("the mesh cannot be repaired");
  const Origin_map map =
    mesh.surface.add_property_map<Surface::Vertex_index, std::array<std::uint32_t, 2>>(name_of_origins).first;
  const std::size_t given = whole.points.size() - origins.size();
  for(const Surface::Vertex_index v : mesh.surface.vertices())
    map[v] = v.idx() < given ? std::array<std::uint32_t, 2>{v.idx(), v.idx()} : origins[v.idx() - given];
  mesh.complex.reset();
  mesh.repair = result.counts;
}

Mesh read_mesh(const std::string& path,
               bool are_faces_triangulated,
               const std::string& vertex_property,
               const Repair_options* repair,
               bool is_border_taken)
{
  Input_findings findings;
  Polygon_soup soup = read_checked_soup(path, are_faces_triangulated, vertex_property, findings);
  if(is_border_taken && !soup.tetrahedra.empty())
    take_border_of_tetrahedra(soup);
  std::optional<Polygons> faces; // of a file that has other ones than triangles
  Polygon_soup uncut;            // the same with how often they are there, if they may be repaired
  if(!soup.polygons.are_triangles())
  {
    leave_out_repeated_faces(soup, findings);
    faces = soup.polygons;
    if(repair != nullptr)
      uncut = soup;
    triangulate_faces(soup, path, findings);
  }
  Mesh mesh = make_mesh(soup, faces ? &*faces : nullptr);
  if(mesh.complex && !faces) // else no face is repeated
  {
    leave_out_repeated_faces(soup, findings);
    if(!findings.repeated_faces.empty())
      mesh = make_mesh(soup);
  }
  look_over_points(soup, border_points(soup, mesh), findings);
  if(repair != nullptr && is_to_be_repaired(soup, mesh, *repair))
  {
    if(mesh.complex && !soup.edges.empty())
      soup.notes.push_back("edges of no face are left out");
    repair_mesh(mesh.complex && faces ? uncut : soup, *repair, mesh);
    look_over_repaired(mesh, findings);
  }
  mesh.findings = findings;
  if(!vertex_property.empty())
  {
    const Scalar_map scalar_map = mesh.surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
    for(std::size_t v = 0; v < soup.scalars.size(); ++v)
      scalar_map[Surface::Vertex_index(static_cast<Surface::size_type>(v))] = soup.scalars[v];
    set_added_vertices(mesh.surface, scalar_map);
  }
  mesh.notes = std::move(soup.notes);
  return mesh;
}

} // namespace reeb_graph_program
