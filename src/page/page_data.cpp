// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "base/progress_bar.h"
#include "base/surface.h"
#include "page/surface_follower.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/endian/conversion.hpp>

#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The faces that a page shows.
struct Shown_faces
{
  std::vector<std::uint32_t> corners; // three indices of vertices of the surface for each face
  std::optional<std::vector<std::int32_t>> patches;
};
typedef std::vector<std::uint32_t> Corners; // three vertices for each face

void append_corners(const Surface& surface, Surface::Face_index f, Corners& corners)
{
  for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
    corners.push_back(v.idx());
}

double largest_extent(const CGAL::Bbox_3& box)
{
  return (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

// Three coordinates for each vertex, around the centre and by the size of the box, as single precision is enough then.
std::vector<float> relative_positions(const Surface& surface)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double size = largest_extent(box);
  std::vector<float> positions;
  positions.reserve(3 * (surface.number_of_vertices() + surface.number_of_removed_vertices()));
  for(const Point& point : surface.points())
    for(int i = 0; i != 3; ++i)
      positions.push_back(size > 0 ? static_cast<float>((point[i] - (box.min(i) + box.max(i)) / 2) / size) : 0.f);
  return positions;
}

// One face at each of the vertices that have any. Without it, the vertex is on the border of the other faces, and stays.
std::vector<bool> faces_to_keep(const Surface& surface, const std::vector<Surface::Vertex_index>& vertices_to_keep)
{
  std::vector<bool> is_kept(surface.number_of_faces() + surface.number_of_removed_faces());
  for(const Surface::Vertex_index v : vertices_to_keep)
    if(!surface.is_isolated(v) && !surface.is_border(v))
      is_kept[surface.face(surface.halfedge(v)).idx()] = true;
  return is_kept;
}

// The faces that are left of so many, the borders of which stay.
void collapse_edges(const std::vector<float>& positions, std::size_t number_of_faces, Corners& corners)
{
  constexpr float any_error = (std::numeric_limits<float>::max)();
  const std::size_t number_of_vertices = positions.size() / 3;
  corners.resize(meshopt_simplify(corners.data(), corners.data(), corners.size(), positions.data(), number_of_vertices,
                                  3 * sizeof(float), 3 * number_of_faces, any_error, meshopt_SimplifyLockBorder));
}

Shown_faces all_faces(const Surface& surface, const std::optional<Patch_map>& patch_map)
{
  Shown_faces result;
  result.corners.reserve(3 * surface.number_of_faces());
  for(const Surface::Face_index f : surface.faces())
    append_corners(surface, f, result.corners);
  if(patch_map)
  {
    result.patches.emplace();
    for(const Surface::Face_index f : surface.faces())
      result.patches->push_back((*patch_map)[f]);
  }
  return result;
}

// Collapses edges into one of their ends, those first that change the shape least, until few enough faces are left. The
// vertices that are named, and those on borders and between patches, stay. Patches come one after the other.
Shown_faces decimate(const Surface& surface,
                     std::size_t number_of_faces,
                     const std::vector<Surface::Vertex_index>& vertices_to_keep,
                     const std::optional<Patch_map>& patch_map)
{
  const std::vector<float> positions = relative_positions(surface);
  const std::vector<bool> is_kept = faces_to_keep(surface, vertices_to_keep);
  const double share = double(number_of_faces) / double(surface.number_of_faces());
  std::map<std::int32_t, Corners> kept, others; // by patch
  for(const Surface::Face_index f : surface.faces())
    append_corners(surface, f, (is_kept[f.idx()] ? kept : others)[patch_map ? (*patch_map)[f] : 0]);

  Shown_faces result;
  if(patch_map)
    result.patches.emplace();
  Progress_bar progress_bar("page");
  const auto append = [&](const std::pair<const std::int32_t, Corners>& patch) {
    result.corners.insert(result.corners.end(), patch.second.begin(), patch.second.end());
    if(result.patches)
      result.patches->resize(result.corners.size() / 3, patch.first);
  };
  for(auto& patch : others)
  {
    progress_bar(double(result.corners.size()) / double(3 * number_of_faces));
    const std::size_t size = (patch.second.size() + kept[patch.first].size()) / 3;
    const std::size_t number_left = static_cast<std::size_t>(share * double(size));
    const std::size_t number_kept = kept[patch.first].size() / 3;
    collapse_edges(positions, number_left - (std::min)(number_left, number_kept), patch.second);
    append(patch);
  }
  for(const auto& patch : kept)
    append(patch);
  return result;
}

// The place of a vertex in the graph as the page writes it.
std::int32_t page_place(std::size_t place, std::size_t number_of_nodes)
{
  return place < number_of_nodes ? -1 - static_cast<std::int32_t>(place)
                                 : static_cast<std::int32_t>(place - number_of_nodes);
}

// Shows these faces with their corners, and the isolated vertices.
Display_surface show(const Shown_surface& shown, const Page_frame& frame, Shown_faces faces)
{
  const Surface& surface = shown.surface;
  Display_surface result;
  constexpr std::uint32_t left_out = (std::numeric_limits<std::uint32_t>::max)();
  result.new_numbers.assign(surface.number_of_vertices() + surface.number_of_removed_vertices(), left_out);
  for(const std::uint32_t corner : faces.corners)
    result.new_numbers[corner] = 0;
  for(const Surface::Vertex_index v : surface.vertices())
  {
    if(result.new_numbers[v.idx()] == left_out && !surface.is_isolated(v))
      continue;
    result.new_numbers[v.idx()] = static_cast<std::uint32_t>(result.values.size());
    for(int i = 0; i != 3; ++i)
      result.positions.push_back(static_cast<float>(surface.point(v)[i] - frame.origin[i]));
    result.values.push_back(shown.scalar_map[v]);
    result.vertex_arcs.push_back(page_place(shown.places[v.idx()], shown.number_of_nodes));
  }
  for(std::uint32_t& corner : faces.corners)
    corner = result.new_numbers[corner];
  result.triangles = std::move(faces.corners);
  result.face_patches = std::move(faces.patches);
  return result;
}

} // namespace

Page_frame::Page_frame(const Surface& surface)
{
  constexpr double largest_coordinate = 1e30;
  for(const Surface::Vertex_index v : surface.vertices())
    for(int i = 0; i != 3; ++i)
      if(!(std::abs(surface.point(v)[i]) <= largest_coordinate))
        throw std::runtime_error("a page shows no coordinates beyond 1e30");
  if(surface.number_of_vertices() == 0)
    return;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double size = largest_extent(box);
  if(size > 0 && size < 1 / largest_coordinate)
    throw std::runtime_error("a page shows no surface of a size below 1e-30");
  constexpr double far_away = 10; // sizes
  for(int i = 0; i != 3; ++i)
    if((std::max)(std::abs(box.min(i)), std::abs(box.max(i))) > far_away * size)
    {
      origin = {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2};
      break;
    }
  if(size > 0)
    digits = std::pow(10., 7 - std::floor(std::log10(size)));
}

std::array<double, 3> Page_frame::coordinates(const Point& point) const
{
  return {rounded(point.x() - origin[0]), rounded(point.y() - origin[1]), rounded(point.z() - origin[2])};
}

double Page_frame::rounded(double number) const
{
  const double result = std::round(number * digits) / digits;
  return std::isfinite(result) ? result : number;
}

Display_surface display_surface(const Shown_surface& shown, const Page_frame& frame)
{
  constexpr std::size_t largest_number_of_faces = 200000;
  if(shown.surface.number_of_faces() <= largest_number_of_faces)
    return show(shown, frame, all_faces(shown.surface, shown.patch_map));
  Display_surface result =
    show(shown, frame, decimate(shown.surface, largest_number_of_faces, shown.vertices_to_keep, shown.patch_map));
  result.is_decimated = true;
  result.new_numbers.clear();
  return result;
}

// The base64 code of numbers, little-endian on any machine.
template <class Number>
std::string base64(const std::vector<Number>& numbers)
{
  std::vector<unsigned char> bytes(numbers.size() * sizeof(Number));
  if(!numbers.empty())
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  if(boost::endian::order::native == boost::endian::order::big)
    for(auto number = bytes.begin(); number != bytes.end(); number += sizeof(Number))
      std::reverse(number, number + sizeof(Number));
  return CGAL::Reeb_graph::internal::base64_code(bytes);
}

namespace {
Embedded_graph embed(Mesh_graph& shown)
{
  namespace parameters = CGAL::parameters;
  Progress_bar progress_bar("embedding");
  auto embedding = CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(
    shown.surface_augmentation(),
    parameters::number_of_contours(16).number_of_contours_at_nodes(2).number_of_smoothing_steps(1).callback(
      std::ref(progress_bar)));
  const Surface_follower follow(shown.surface_augmentation().mesh());
  for(Point& point : embedding.node_points)
    point = follow(point);
  for(Polyline& line : embedding.arc_polylines)
    line = follow(line);
  return {shown.result(), std::move(embedding.node_points), std::move(embedding.arc_polylines), shown.arc_table()};
}

nlohmann::ordered_json page_chain(const Surface& surface,
                                  const CGAL::Reeb_graph::Halfedge_chain<Surface::Halfedge_index>& chain,
                                  const std::vector<std::uint32_t>& new_numbers)
{
  auto json = nlohmann::ordered_json::array();
  for(std::size_t i = 0; i != chain.size(); ++i)
  {
    const Surface::Vertex_index from = surface.source(chain[i]);
    if(i == 0 || surface.target(chain[i - 1]) != from)
      json.push_back(new_numbers[from.idx()]);
    json.push_back(new_numbers[surface.target(chain[i]).idx()]);
  }
  return json;
}

void add_chains(const Augmentation& augmentation, const Display_surface& surface, nlohmann::ordered_json& arcs)
{
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(augmentation.graph())))
  {
    nlohmann::ordered_json& json = arcs[number++];
    json["chain"] = page_chain(augmentation.mesh(), augmentation.graph()[arc].chain, surface.new_numbers);
    json["contours"] = nullptr;
  }
}

// A polyline with at most so many points, of which the first one is not repeated at the end.
nlohmann::ordered_json page_polyline(const Polyline& polyline, std::size_t number_of_points, const Page_frame& frame)
{
  const bool is_closed = polyline.size() > 1 && polyline.front() == polyline.back();
  const std::size_t size = polyline.size() - (is_closed ? 1 : 0);
  const std::size_t step = (size + number_of_points - 1) / (std::max<std::size_t>)(number_of_points, 1);
  std::vector<float> coordinates;
  for(std::size_t i = 0; i < size; i += step)
  {
    const bool is_end_next = !is_closed && i + step >= size; // the ends of an open one stay
    for(const double coordinate : frame.coordinates(polyline[is_end_next ? size - 1 : i]))
      coordinates.push_back(static_cast<float>(coordinate));
  }
  return {{"points", base64(coordinates)}, {"is_closed", is_closed}};
}

// Contours of the whole surface, as the page cannot trace any on a decimated one.
void add_contours(const Augmentation& augmentation, const Page_frame& frame, nlohmann::ordered_json& arcs)
{
  constexpr std::size_t number_of_points = 300, number_of_all_points = 1000000, largest_number_of_contours = 16;
  const std::size_t number_of_contours = std::clamp<std::size_t>(
    number_of_all_points / number_of_points / (std::max<std::size_t>)(arcs.size(), 1), 1, largest_number_of_contours);
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(augmentation.graph())))
  {
    nlohmann::ordered_json& json = arcs[number++];
    json["chain"] = nullptr;
    auto& contours = json["contours"] = nlohmann::ordered_json::array();
    for(std::size_t i = 0; i != number_of_contours; ++i)
    {
      const double t = (double(i) + 0.5) / double(number_of_contours);
      const auto contour = augmentation.contour(arc, t);
      Polyline polyline;
      polyline.reserve(contour.number_of_crossings() + 1);
      augmentation.points_of_contour(contour, std::back_inserter(polyline));
      if(contour.is_closed())
        polyline.push_back(polyline.front());
      nlohmann::ordered_json points = page_polyline(polyline, number_of_points, frame);
      points["t"] = t;
      points["value"] = number_or_string(contour.value);
      contours.push_back(std::move(points));
    }
  }
}

nlohmann::ordered_json page_curves(const std::vector<Polyline>& curves, const Page_frame& frame)
{
  auto json = nlohmann::ordered_json::array();
  for(const Polyline& curve : curves)
    json.push_back(page_polyline(curve, curve.size(), frame));
  return json;
}

nlohmann::ordered_json page_loops(const std::vector<Loop_row>& loops)
{
  auto json = nlohmann::ordered_json::array();
  for(const Loop_row& loop : loops)
    json.push_back(
      {{"kind", loop.kind},
       {"length", loop.length},
       {"persistence", loop.persistence ? number_or_string(*loop.persistence) : nlohmann::ordered_json()}});
  return json;
}

} // namespace

nlohmann::ordered_json begin_data(const std::string& title,
                                  const std::string& up,
                                  const Field_label& field,
                                  const Value_scale& value_scale)
{
  nlohmann::ordered_json data;
  data["version"] = 1;
  data["title"] = title;
  data["generator"] = "reeb_graph " REEB_GRAPH_VERSION;
  data["up"] = up;
  data["field"] = {
    {"name", field.name}, {"unit", field.unit}, {"lowest", value_scale.lowest()}, {"highest", value_scale.highest()}};
  return data;
}

nlohmann::ordered_json page_surface(std::size_t number_of_faces,
                                    const Display_surface& surface,
                                    const Page_frame& frame)
{
  nlohmann::ordered_json json;
  json["faces_of_input"] = number_of_faces;
  json["is_decimated"] = surface.is_decimated;
  json["origin"] = frame.origin;
  json["positions"] = base64(surface.positions);
  json["values"] = base64(surface.values);
  json["triangles"] = base64(surface.triangles);
  json["vertex_arcs"] = base64(surface.vertex_arcs);
  json["face_patches"] = surface.face_patches ? nlohmann::ordered_json(base64(*surface.face_patches)) : nullptr;
  return json;
}

// The vertices of a chain by their numbers in the page.
nlohmann::ordered_json page_data(const Page_request& request, Mesh_graph& shown)
{
  const Augmentation& augmentation = shown.surface_augmentation();
  const Surface& mesh = augmentation.mesh();
  const Page_frame frame(mesh);
  std::vector<double> values;
  for(const Surface::Vertex_index v : mesh.vertices())
    values.push_back(request.scalar_map[v]);
  const Value_scale value_scale(values);
  std::vector<Surface::Vertex_index> vertices_to_keep;
  for(const auto node : CGAL::make_range(vertices(augmentation.graph())))
    vertices_to_keep.push_back(augmentation.graph()[node].vertex);
  const Display_surface surface = display_surface(
    {mesh, request.scalar_map, shown.places(), num_vertices(augmentation.graph()), vertices_to_keep, request.patch_map},
    frame);
  const Embedded_graph embedded = embed(shown);

  nlohmann::ordered_json data = begin_data(request.title, request.up, request.field_label, value_scale);
  data["skeleton"] = nullptr;
  data["surface"] = page_surface(mesh.number_of_faces(), surface, frame);
  data["columns"] = page_columns(shown.arc_table());
  data["graph"] = page_graph(embedded, frame, value_scale);
  if(surface.is_decimated)
    add_contours(augmentation, frame, data["graph"]["arcs"]);
  else
    add_chains(augmentation, surface, data["graph"]["arcs"]);
  data["levels"] = page_levels(embedded, frame, value_scale);
  data["ticks"] = page_ticks(embedded.graph, data["levels"]);
  data["curves"] = page_curves(request.curves, frame);
  data["loops"] = page_loops(request.loops);
  return data;
}

nlohmann::ordered_json page_data(const Page_of_shapes& page)
{
  const auto data_of = [](const Page_request& request) {
    nlohmann::ordered_json data = page_data(request, request.graph);
    data["levels"].erase(data["levels"].begin() + 1, data["levels"].end());
    data["ticks"] = nlohmann::ordered_json::array();
    return data;
  };
  nlohmann::ordered_json data = data_of(page.a);
  data["other"] = data_of(page.b);
  data["partners"] = page.partners;
  data["distance"] = number_or_string(page.distance);
  return data;
}

} // namespace reeb_graph_program
