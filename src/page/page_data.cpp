// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "base/base64.h"
#include "page/display_surface.h"
#include "page/page_graph.h"
#include "page/page_levels.h"

#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/boost/graph/iterator.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <utility>

namespace reeb_graph_program {
namespace {
Embedded_graph embed(const Page_subject& subject, const Vertex_locations& locations)
{
  namespace parameters = CGAL::parameters;
  auto embedding = CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(
    subject.augmentation, parameters::number_of_contours(16, parameters::number_of_smoothing_steps(1)));
  return {subject.graph(), std::move(embedding.node_points), std::move(embedding.arc_polylines),
          measure_arcs(subject.surface(), subject.scalar_map, subject.graph(), locations)};
}

nlohmann::ordered_json page_surface(const Page_subject& subject,
                                    const Display_surface& surface,
                                    const Page_frame& frame)
{
  nlohmann::ordered_json json;
  json["faces_of_input"] = subject.surface().number_of_faces();
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

// What leads from arcs to the surface.
void add_chains(const Page_subject& subject, const Display_surface& surface, nlohmann::ordered_json& graph)
{
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(subject.graph())))
  {
    nlohmann::ordered_json& json = graph["arcs"][number++];
    json["chain"] = page_chain(subject.surface(), subject.graph()[arc].chain, surface.new_numbers);
    json["contours"] = nullptr;
  }
}

nlohmann::ordered_json page_curves(const std::vector<Polyline>& curves, const Page_frame& frame)
{
  auto json = nlohmann::ordered_json::array();
  for(const Polyline& curve : curves)
  {
    const bool is_closed = curve.size() > 1 && curve.front() == curve.back();
    std::vector<float> coordinates;
    for(std::size_t i = 0; i + (is_closed ? 1 : 0) < curve.size(); ++i)
      for(const double coordinate : frame.coordinates(curve[i]))
        coordinates.push_back(static_cast<float>(coordinate));
    json.push_back({{"points", base64(coordinates)}, {"is_closed", is_closed}});
  }
  return json;
}

} // namespace

Page_labels page_labels(const Input_options& input, const std::string& unit)
{
  const std::string file_name = std::filesystem::path(input.mesh_path).filename().string();
  if(!input.field.empty())
    return {file_name, input.field, unit};
  const bool is_column_named = input.column.find_first_not_of("0123456789") != std::string::npos;
  return {file_name, is_column_named ? input.column : std::filesystem::path(input.scalars_path).stem().string(), unit};
}

nlohmann::ordered_json page_data(const Page_subject& subject)
{
  const Page_frame frame(subject.surface());
  const Drawn_values drawn_values(subject.surface(), subject.scalar_map);
  const Vertex_locations locations = locate_vertices(subject.augmentation);
  const Display_surface surface = display_surface(subject, frame, locations);
  const Embedded_graph embedded = embed(subject, locations);

  nlohmann::ordered_json data;
  data["version"] = 1;
  data["title"] = subject.labels.title;
  data["generator"] = "reeb_graph " REEB_GRAPH_VERSION;
  data["field"] = {{"name", subject.labels.field_name},
                   {"unit", subject.labels.unit},
                   {"lowest", drawn_values.lowest},
                   {"highest", drawn_values.highest}};
  data["surface"] = page_surface(subject, surface, frame);
  data["graph"] = page_graph(embedded, frame, drawn_values);
  add_chains(subject, surface, data["graph"]);
  data["levels"] = page_levels(embedded, frame, drawn_values);
  data["curves"] = page_curves(subject.curves, frame);
  return data;
}

} // namespace reeb_graph_program
