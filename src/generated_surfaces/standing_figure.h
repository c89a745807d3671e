// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_STANDING_FIGURE_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_STANDING_FIGURE_H

#include "generated_surfaces/Triangle_soup.h"
#include "generated_surfaces/implicit_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace generated_surfaces {
namespace internal {
// A part of a body: what is nearer to a segment than a radius that changes along it.
struct Limb
{
  Vector from, to;
  double radius_from, radius_to;

  double distance(const Vector& p) const
  {
    const Vector along = difference(to, from);
    const double t = std::clamp(dot(difference(p, from), along) / dot(along, along), 0., 1.);
    const Vector offset = difference(p, moved(from, t, along));
    return std::sqrt(dot(offset, offset)) - ((1 - t) * radius_from + t * radius_to);
  }
};

// Somebody who looks along -y, with one hand on the hip, and waves with the other one, on whose arm a bird sits.
constexpr std::array<Limb, 23> standing_figure_limbs = {
  {{{0, -.01, 1.60}, {0, 0, 1.66}, .105, .115},      // head
   {{0, -.10, 1.61}, {0, -.125, 1.585}, .018, .022}, // nose
   {{0, .01, 1.36}, {0, 0, 1.52}, .06, .055},        // neck
   {{-.15, .01, 1.33}, {0, .01, 1.36}, .065, .07},   // shoulders
   {{.15, .01, 1.33}, {0, .01, 1.36}, .065, .07},
   {{-.06, 0, 1.24}, {-.045, 0, 1.02}, .115, .10}, // trunk
   {{.06, 0, 1.24}, {.045, 0, 1.02}, .115, .10},
   {{-.07, .01, .90}, {-.04, 0, 1.02}, .125, .10}, // hips
   {{.07, .01, .90}, {.04, 0, 1.02}, .125, .10},
   {{-.10, .01, .86}, {-.13, -.01, .48}, .095, .06}, // legs
   {{-.13, -.01, .48}, {-.16, .02, .09}, .06, .042},
   {{-.16, .03, .065}, {-.185, -.14, .05}, .048, .04},
   {{.10, .01, .86}, {.13, -.01, .48}, .095, .06},
   {{.13, -.01, .48}, {.16, .02, .09}, .06, .042},
   {{.16, .03, .065}, {.185, -.14, .05}, .048, .04},
   {{-.18, .01, 1.32}, {-.43, .05, 1.14}, .06, .045}, // the arm with the hand on the hip
   {{-.43, .05, 1.14}, {-.16, -.02, .96}, .045, .036},
   {{.18, .01, 1.33}, {.40, .02, 1.40}, .058, .046}, // the arm that waves
   {{.40, .02, 1.40}, {.50, -.03, 1.62}, .045, .034},
   {{.50, -.03, 1.65}, {.515, -.035, 1.71}, .047, .052},
   {{.52, -.035, 1.72}, {.54, -.04, 1.82}, .042, .03},
   {{.29, .01, 1.45}, {.285, -.005, 1.60}, .042, .05}, // the bird
   {{.285, -.01, 1.66}, {.285, -.015, 1.69}, .036, .038}}};

// The smooth union of the limbs: a sum of exponentials, so that they grow into each other.
inline double standing_figure_function(const Vector& p)
{
  constexpr double smoothness = 0.012;
  double sum = 0;
  for(const Limb& limb : standing_figure_limbs)
    sum += std::exp(-std::max(limb.distance(p), -0.5) / smoothness);
  return -smoothness * std::log(std::max(sum, 1e-300));
}

} // namespace internal

// A standing figure, 1.85 high in the direction z, with one hand on the hip: a closed surface of genus 1. By height, it
// has a minimum at each foot, and a maximum at the head, at the other hand, and at the bird that sits on that arm; the
// least of them is 14 percent of the range above its saddle, more than noise of 5 percent makes. It has
// about the given number of vertices, some thousands at least.
inline Triangle_soup standing_figure(std::size_t number_of_vertices)
{
  constexpr double area_per_cell = 8.2; // of the surface, times the number of vertices of a cell
  const double cell_size = std::sqrt(area_per_cell / static_cast<double>(std::max<std::size_t>(number_of_vertices, 1)));
  internal::Marching_tetrahedra surface(internal::standing_figure_function, {-.6, -.3, -.05}, {.65, .25, 1.95},
                                        cell_size);
  Triangle_soup soup = surface.take_surface();
  internal::smooth(soup, internal::standing_figure_function, 12);
  return soup;
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_STANDING_FIGURE_H
