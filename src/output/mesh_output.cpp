// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/mesh_output.h"

#include "output/output_file.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reeb_graph_program {
namespace {
// From blue over white to red as `t` goes from 0 to 1.
CGAL::IO::Color colour(double t)
{
  const std::array<std::array<double, 3>, 3> stops = {{{33, 102, 172}, {247, 247, 247}, {178, 24, 43}}};
  const std::size_t i = t < 0.5 ? 0 : 1;
  const double u = 2 * t - i;
  std::array<unsigned char, 3> rgb;
  for(std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<unsigned char>(std::lround((1 - u) * stops[i][c] + u * stops[i + 1][c]));
  return CGAL::IO::Color(rgb[0], rgb[1], rgb[2]);
}

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

} // namespace

void write_surface(const std::filesystem::path& path, const Surface& surface)
{
  write_file(path, [&](std::ostream& stream) {
    const int precision = std::numeric_limits<double>::max_digits10;
    CGAL::IO::write_OFF(stream, surface, CGAL::parameters::stream_precision(precision));
  });
}

void write_scalars(const std::filesystem::path& path, const Surface& surface, Scalar_map scalar_map)
{
  write_file(path, [&](std::ostream& stream) {
    stream.precision(std::numeric_limits<double>::max_digits10);
    for(const Surface::Vertex_index v : surface.vertices())
      stream << scalar_map[v] << '\n';
  });
}

void write_coloured_surface(const std::filesystem::path& path, Surface surface, Scalar_map scalar_map)
{
  const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
  const auto colour_map = surface.add_property_map<Surface::Vertex_index, CGAL::IO::Color>("v:color").first;
  for(const Surface::Vertex_index v : surface.vertices())
    colour_map[v] = colour((scalar_map[v] - *lowest) / (*highest - *lowest));
  write_file(path, [&](std::ostream& stream) {
    CGAL::IO::set_binary_mode(stream);
    CGAL::IO::write_PLY(stream, surface);
  });
}

void write_surface_with_patches(const std::filesystem::path& path, Surface surface, Patch_map patch_map)
{
  const auto colour_map = surface.add_property_map<Surface::Face_index, CGAL::IO::Color>("f:color").first;
  for(const Surface::Face_index f : surface.faces())
    colour_map[f] = colour_of_patch(patch_map[f]);
  write_file(path, [&](std::ostream& stream) {
    CGAL::IO::set_binary_mode(stream);
    CGAL::IO::write_PLY(stream, surface);
  });
}

} // namespace reeb_graph_program
