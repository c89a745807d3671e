// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "base/progress_bar.h"
#include "page/surface_follower.h"

#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/endian/conversion.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
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
  std::ostringstream out;
  CGAL::Reeb_graph::internal::write_base64(out, std::move(bytes));
  return out.str();
}

namespace {
std::vector<double> values(const Page_subject& subject)
{
  std::vector<double> result;
  for(const Surface::Vertex_index v : subject.surface().vertices())
    result.push_back(subject.scalar_map[v]);
  return result;
}

Embedded_graph embed(const Page_subject& subject)
{
  namespace parameters = CGAL::parameters;
  Progress_bar progress_bar("embedding");
  auto embedding = CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(
    subject.augmentation,
    parameters::number_of_contours(16).number_of_contours_at_nodes(2).number_of_smoothing_steps(1).callback(
      std::ref(progress_bar)));
  const Surface_follower follow(subject.surface());
  for(Point& point : embedding.node_points)
    point = follow(point);
  for(Polyline& line : embedding.arc_polylines)
    line = follow(line);
  return {subject.graph(), std::move(embedding.node_points), std::move(embedding.arc_polylines), subject.arc_table};
}

Shown_surface shown_surface(const Page_subject& subject)
{
  Shown_surface shown = {subject.surface(), subject.scalar_map, subject.places, num_vertices(subject.graph()), {},
                         subject.patch_map};
  for(const auto node : CGAL::make_range(vertices(subject.graph())))
    shown.vertices_to_keep.push_back(subject.graph()[node].vertex);
  return shown;
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

void add_chains(const Page_subject& subject, const Display_surface& surface, nlohmann::ordered_json& arcs)
{
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(subject.graph())))
  {
    nlohmann::ordered_json& json = arcs[number++];
    json["chain"] = page_chain(subject.surface(), subject.graph()[arc].chain, surface.new_numbers);
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
void add_contours(const Page_subject& subject, const Page_frame& frame, nlohmann::ordered_json& arcs)
{
  constexpr std::size_t number_of_points = 300, number_of_all_points = 1000000, largest_number_of_contours = 16;
  const std::size_t number_of_contours = std::clamp<std::size_t>(
    number_of_all_points / number_of_points / (std::max<std::size_t>)(arcs.size(), 1), 1, largest_number_of_contours);
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(subject.graph())))
  {
    nlohmann::ordered_json& json = arcs[number++];
    json["chain"] = nullptr;
    auto& contours = json["contours"] = nlohmann::ordered_json::array();
    for(std::size_t i = 0; i != number_of_contours; ++i)
    {
      const double t = (double(i) + 0.5) / double(number_of_contours);
      const auto contour = subject.augmentation.contour(arc, t);
      Polyline polyline;
      polyline.reserve(contour.number_of_crossings() + 1);
      subject.augmentation.points_of_contour(contour, std::back_inserter(polyline));
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
nlohmann::ordered_json page_data(const Page_subject& subject)
{
  const Page_frame frame(subject.surface());
  const Value_scale value_scale(values(subject));
  const Display_surface surface = display_surface(shown_surface(subject), frame);
  const Embedded_graph embedded = embed(subject);

  nlohmann::ordered_json data = begin_data(subject.title, subject.up, subject.field_label, value_scale);
  data["skeleton"] = nullptr;
  data["surface"] = page_surface(subject.surface().number_of_faces(), surface, frame);
  data["columns"] = page_columns(subject.arc_table);
  data["graph"] = page_graph(embedded, frame, value_scale);
  if(surface.is_decimated)
    add_contours(subject, frame, data["graph"]["arcs"]);
  else
    add_chains(subject, surface, data["graph"]["arcs"]);
  data["levels"] = page_levels(embedded, frame, value_scale);
  data["ticks"] = page_ticks(embedded.graph, data["levels"]);
  data["curves"] = page_curves(subject.curves, frame);
  data["loops"] = page_loops(subject.loops);
  return data;
}

} // namespace reeb_graph_program
