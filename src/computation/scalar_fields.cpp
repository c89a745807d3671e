// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/scalar_fields.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/harmonic_field_between_borders.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/Reeb_graph/fields/unit_gradient_field.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef Surface::Vertex_index Vertex;
typedef CGAL::Reeb_graph::Field_report Field_report;

Vertex vertex(const Surface& surface, std::size_t number)
{
  if(number >= surface.number_of_vertices())
    throw std::runtime_error("there is no vertex " + std::to_string(number) + ": the mesh has "
                             + std::to_string(surface.number_of_vertices()) + ", numbered from 0");
  return Vertex(static_cast<Surface::size_type>(number));
}

// The vertices that are given, else one in each component, far away from another one.
std::vector<Vertex> sources(const Input_options& options, const Surface& surface)
{
  std::vector<Vertex> result;
  for(const std::size_t number : options.source_vertices)
    result.push_back(vertex(surface, number));
  if(!result.empty())
    return result;
  std::vector<std::pair<Vertex, Vertex>> pairs;
  Progress_bar progress_bar("far vertices");
  CGAL::Reeb_graph::find_far_apart_vertices(surface, std::back_inserter(pairs),
                                            CGAL::parameters::callback(std::ref(progress_bar)));
  for(const auto& pair : pairs)
    result.push_back(pair.first);
  return result;
}

CGAL::Reeb_graph::Laplacian_weights weights(const Input_options& options)
{
  using CGAL::Reeb_graph::Laplacian_weights;
  return options.weights == "cotangent" ? Laplacian_weights::COTANGENT
       : options.weights == "uniform"   ? Laplacian_weights::UNIFORM
                                        : Laplacian_weights::MEAN_VALUE;
}

Field_report compute_harmonic(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  Progress_bar progress_bar("harmonic field");
  const auto np = CGAL::parameters::laplacian_weights(weights(options)).callback(std::ref(progress_bar));
  if(options.lowest_vertex)
    return CGAL::Reeb_graph::compute_harmonic_field_between(
      surface, scalar_map, vertex(surface, *options.lowest_vertex), vertex(surface, *options.highest_vertex), np);
  if(options.are_borders_fixed)
    return CGAL::Reeb_graph::compute_harmonic_field_between_borders(surface, scalar_map, np);
  return CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices(surface, scalar_map, np);
}

Field_report compute_poisson(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  std::vector<std::pair<Vertex, double>> constraints;
  for(const Vertex v : sources(options, surface))
    constraints.emplace_back(v, 0.);
  Progress_bar progress_bar("Poisson field");
  return CGAL::Reeb_graph::compute_curvature_poisson_field(surface, scalar_map, constraints,
                                                           CGAL::parameters::callback(std::ref(progress_bar)));
}

Field_report compute_geodesic(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  const std::vector<Vertex> source_vertices = sources(options, surface);
  Progress_bar progress_bar("geodesic field");
  return CGAL::Reeb_graph::compute_geodesic_field(surface, scalar_map, source_vertices,
                                                  CGAL::parameters::callback(std::ref(progress_bar)));
}

// The map holds the field to start from.
Field_report compute_unit_gradient(const Surface& surface, Scalar_map scalar_map)
{
  Progress_bar progress_bar("unit gradient field");
  return CGAL::Reeb_graph::compute_unit_gradient_field(surface, scalar_map, scalar_map,
                                                       CGAL::parameters::callback(std::ref(progress_bar)));
}

void compute_height(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
  const std::vector<double> z = {0, 0, 1}, &d = options.direction.empty() ? z : options.direction;
  Progress_bar progress_bar("height");
  CGAL::Reeb_graph::compute_height_field(surface, scalar_map, Vector(d[0], d[1], d[2]),
                                         CGAL::parameters::callback(std::ref(progress_bar)));
}

void check(bool is_right, const std::string& message)
{
  if(!is_right)
    throw std::runtime_error(message);
}

} // namespace

bool is_computed(const std::string& field)
{
  constexpr std::array<std::string_view, 5> names = {"height", "harmonic", "poisson", "geodesic", "unit-gradient"};
  return std::find(names.begin(), names.end(), field) != names.end();
}

void check_field_options(const Input_options& options)
{
  const std::string& field = options.field;
  const bool is_harmonic = field == "harmonic" || (field == "unit-gradient" && options.scalars_path.empty());
  check(!field.empty() || !options.scalars_path.empty(), "a field is needed, such as --field z or --scalars FILE");
  check(field.empty() || field == "unit-gradient" || options.scalars_path.empty(),
        "--scalars goes with the field unit-gradient only, or without any");
  check(options.column.empty() || !options.scalars_path.empty(), "--column goes with --scalars only");
  check(options.lowest_vertex.has_value() == options.highest_vertex.has_value(), "--min and --max go together");
  check(!options.lowest_vertex || is_harmonic, "--min and --max go with the field harmonic only");
  check(options.weights.empty() || is_harmonic, "--weights goes with the field harmonic only");
  check(options.source_vertices.empty() || field == "poisson" || field == "geodesic",
        "--source goes with the fields poisson and geodesic only");
  check(options.direction.empty() || field == "height", "--direction goes with the field height only");
}

std::optional<Field_report> compute_scalar_field(const Input_options& options,
                                                 const Surface& surface,
                                                 Scalar_map scalar_map)
{
  if(options.field == "harmonic")
    return compute_harmonic(options, surface, scalar_map);
  if(options.field == "poisson")
    return compute_poisson(options, surface, scalar_map);
  if(options.field == "geodesic")
    return compute_geodesic(options, surface, scalar_map);
  if(options.field == "unit-gradient")
  {
    if(options.scalars_path.empty())
      compute_harmonic(options, surface, scalar_map);
    return compute_unit_gradient(surface, scalar_map);
  }
  compute_height(options, surface, scalar_map);
  return std::nullopt;
}

} // namespace reeb_graph_program
