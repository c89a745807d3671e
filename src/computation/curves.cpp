// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/curves.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cut_along_levels.h>
#include <CGAL/Reeb_graph/curves/cut_to_disks.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::Curve<Surface::Halfedge_index> Curve;

CGAL::Reeb_graph::Interpolating_visitor<Surface> make_visitor(const std::vector<Any_vertex_property>& properties)
{
  CGAL::Reeb_graph::Interpolating_visitor<Surface> visitor;
  for(const Any_vertex_property& property : properties)
    std::visit([&](const auto& map) { visitor.add_vertex_map(map); }, property);
  return visitor;
}

// Cuts the surface by cut(curves, named parameters, a function that adds those of CGAL to them, result).
template <class Cut>
Cut_result cut_surface(Surface& surface,
                       const std::vector<Any_vertex_property>& properties,
                       bool is_cut_open,
                       const std::function<bool(std::size_t)>& face_count_callback,
                       const Cut& cut)
{
  Cut_result result;
  result.patch_map = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  std::vector<Curve> curves;
  Progress_bar progress_bar("cut");
  const auto tell = [&](std::size_t number_of_faces) {
    progress_bar.clear();
    return face_count_callback(number_of_faces);
  };
  const auto with_maps = [&](const auto& np) {
    return np.face_patch_map(result.patch_map).visitor(make_visitor(properties)).callback(std::ref(progress_bar));
  };
  cut(curves, CGAL::parameters::face_count_callback(tell).cut_open(is_cut_open), with_maps, result);
  for(const Curve& curve : curves)
    result.polylines.push_back(CGAL::Reeb_graph::polyline_of_curve(surface, curve));
  for(const Surface::Face_index f : surface.faces())
    result.number_of_patches = (std::max)(result.number_of_patches, std::size_t(result.patch_map[f]) + 1);
  return result;
}

} // namespace

Cut_result cut_along_curves(Surface& surface,
                            Scalar_map scalar_map,
                            const std::vector<Any_vertex_property>& properties,
                            const Cut_options& options,
                            const std::function<bool(std::size_t)>& face_count_callback)
{
  CGAL::Reeb_graph::Border_level_changes border_changes;
  if(options.borders.value_or(CGAL::Reeb_graph::Borders::MAKE_LEVEL) == CGAL::Reeb_graph::Borders::MAKE_LEVEL)
  {
    Progress_bar progress_bar("borders");
    border_changes =
      CGAL::Reeb_graph::make_borders_level(surface, scalar_map, CGAL::parameters::callback(std::ref(progress_bar)));
  }
  const auto cut = [&](std::vector<Curve>& curves, const auto& np, const auto& with_maps, Cut_result& result) {
    const auto inserter = std::back_inserter(curves);
    result.border_changes = border_changes;
    if(options.type == Curves_type::CUTTING_SYSTEM)
      CGAL::Reeb_graph::cutting_system(surface, scalar_map, inserter, with_maps(np));
    else if(options.type == Curves_type::PANTS)
      CGAL::Reeb_graph::pants_decomposition(surface, scalar_map, inserter, with_maps(np));
    else
      CGAL::Reeb_graph::branch_curves(
        surface, scalar_map, inserter,
        with_maps(np.persistence_threshold(options.persistence.value_or(0))).area_threshold(options.area.value_or(0)));
  };
  return cut_surface(surface, properties, options.is_cut_open, face_count_callback, cut);
}

namespace {
// The multiples of a distance that are inside of the range of the field.
std::vector<double> multiples(double spacing, Scalar_map scalar_map)
{
  if(!(spacing > 0) || !std::isfinite(spacing))
    throw std::runtime_error("--spacing has to be a positive number");
  std::vector<double> levels;
  if(scalar_map.begin() == scalar_map.end())
    return levels;
  const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
  if(!std::isfinite(*lowest) || !std::isfinite(*highest))
    throw std::runtime_error("--spacing needs a field of finite range");
  const double first = std::floor(*lowest / spacing), number = std::ceil(*highest / spacing) - first;
  constexpr double most = 1e7;
  if(!(number <= most))
    throw std::runtime_error("--spacing is so small that there would be more than ten million levels");
  for(double i = 0; i <= number; ++i)
  {
    const double level = (first + i) * spacing;
    if(*lowest < level && level < *highest)
      levels.push_back(level);
  }
  return levels;
}

// Finds an edge beside a curve, one that leads up if there is any.
Level_curve make_level_curve(const Surface& surface, Scalar_map scalar_map, const Curve& curve)
{
  Level_curve result = {curve.value, curve.is_closed, std::nullopt, true};
  for(const bool is_above : {true, false})
    for(const auto* halfedges : {&curve.halfedges, &curve.lower_halfedges})
      for(const Surface::Halfedge_index h : *halfedges)
      {
        if(surface.is_border(h))
          continue;
        const std::size_t of_curve = surface.target(h), beside = surface.target(surface.next(h));
        const double value = scalar_map[surface.target(surface.next(h))];
        if(is_above ? !(curve.value < value) : !(value < curve.value))
          continue;
        result.crossed_edge = is_above ? std::array<std::size_t, 2>{of_curve, beside} : std::array{beside, of_curve};
        result.is_above = is_above;
        return result;
      }
  return result;
}

std::string number_in_words(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

} // namespace

std::vector<double> values_of_levels(const Level_choice& choice, Scalar_map scalar_map)
{
  std::vector<double> levels = choice.number  ? equal_steps(*choice.number, scalar_map)
                             : choice.spacing ? multiples(*choice.spacing, scalar_map)
                                              : choice.values;
  if(std::any_of(levels.begin(), levels.end(), [](double level) { return std::isnan(level); }))
    throw std::runtime_error("a level is not a number (NaN)");
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

Cut_result cut_along_levels(Surface& surface,
                            Scalar_map scalar_map,
                            const std::vector<Any_vertex_property>& properties,
                            const std::vector<double>& levels,
                            bool is_cut_open,
                            const std::function<bool(std::size_t)>& face_count_callback)
{
  const auto cut = [&](std::vector<Curve>& curves, const auto& np, const auto& with_maps, Cut_result& result) {
    result.band_map = surface.add_property_map<Surface::Face_index, int>("f:band", 0).first;
    result.level_report = CGAL::Reeb_graph::cut_along_levels(surface, scalar_map, levels, std::back_inserter(curves),
                                                             with_maps(np.face_band_map(*result.band_map)));
    for(const Curve& curve : curves)
      result.level_curves.push_back(make_level_curve(surface, scalar_map, curve));
  };
  return cut_surface(surface, properties, is_cut_open, face_count_callback, cut);
}

std::vector<Contour> contours_of_levels(const Cut_result& result, Scalar_map scalar_map, Mesh_graph& graph)
{
  std::vector<Contour> contours;
  typedef std::array<std::size_t, 2> Edge;
  std::map<std::pair<double, bool>, std::multimap<Edge, std::size_t>> wanted; // curves by level, side, and edge
  for(std::size_t i = 0; i != result.level_curves.size(); ++i)
  {
    const Level_curve& curve = result.level_curves[i];
    Contour& contour = contours.emplace_back();
    contour.arc = Contour::no_arc;
    contour.value = curve.value;
    contour.is_closed = curve.is_closed;
    contour.points = result.polylines[i];
    contour.points.resize(contour.points.size() - (curve.is_closed ? 1 : 0));
    std::vector<std::size_t>& line = contour.polylines.emplace_back();
    while(line.size() != contour.points.size())
      line.push_back(line.size());
    if(curve.is_closed)
      line.push_back(0);
    if(curve.crossed_edge)
      wanted[{curve.value, curve.is_above}].emplace(*curve.crossed_edge, i);
  }
  std::vector<double> values(scalar_map.begin(), scalar_map.end());
  std::sort(values.begin(), values.end());
  for(const auto& [place, curves_by_edge] : wanted)
  {
    Contour_choice choice;
    choice.may_be_none = true;
    const auto [value, is_above] = place;
    choice.levels = {is_above ? value : *std::prev(std::lower_bound(values.begin(), values.end(), value))};
    for(const Contour& beside : graph.find_contours(choice))
      for(const Edge& edge : beside.edges)
      {
        const auto [begin, end] = curves_by_edge.equal_range(edge);
        for(auto found = begin; found != end; ++found)
          contours[found->second].arc = beside.arc;
      }
  }
  return contours;
}

std::vector<std::string> notes_on_levels(const std::vector<double>& levels,
                                         const Cut_result& result,
                                         Scalar_map scalar_map)
{
  std::vector<double> values;
  for(const Level_curve& curve : result.level_curves)
    values.push_back(curve.value);
  std::vector<std::string> notes;
  constexpr std::size_t most = 8;
  std::size_t number = 0;
  for(const double level : levels)
  {
    if(std::binary_search(values.begin(), values.end(), level) || ++number > most)
      continue;
    const bool is_anywhere = std::find(scalar_map.begin(), scalar_map.end(), level) != scalar_map.end();
    std::string note = "the level " + number_in_words(level)
                     + (is_anywhere ? " meets the mesh in single vertices only" : " meets nothing");
    if(!is_anywhere && scalar_map.begin() != scalar_map.end())
    {
      const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
      note += ": the field is from " + number_in_words(*lowest) + " to " + number_in_words(*highest);
    }
    notes.push_back(note);
  }
  if(number > most)
    notes.push_back("neither do " + std::to_string(number - most) + " more levels");
  return notes;
}

Cut_result cut_to_disks(Surface& surface, std::vector<Any_vertex_property> properties)
{
  const auto original_map = surface.add_property_map<Surface::Vertex_index, std::int32_t>("v:original", 0).first;
  for(const Surface::Vertex_index v : surface.vertices())
    original_map[v] = static_cast<std::int32_t>(v.idx());
  properties.emplace_back(original_map);
  const auto cut = [&](std::vector<Curve>& curves, const auto& np, const auto& with_maps, Cut_result& result) {
    result.original_map = original_map;
    CGAL::Reeb_graph::cut_to_disks(surface, std::back_inserter(curves), with_maps(np));
  };
  return cut_surface(
    surface, properties, true, [](std::size_t) { return true; }, cut);
}

} // namespace reeb_graph_program
