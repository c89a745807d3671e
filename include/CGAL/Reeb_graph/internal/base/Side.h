// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_SIDE_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_SIDE_H

#include <CGAL/license/Reeb_graph.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The side of a level, or of a vertex.
enum class Side : unsigned char
{
  LOWER,
  UPPER
};

inline constexpr std::array<Side, 2> both_sides = {Side::LOWER, Side::UPPER};

constexpr Side side_of(bool is_upper) { return is_upper ? Side::UPPER : Side::LOWER; }
constexpr Side opposite_of(Side side) { return side_of(side == Side::LOWER); }

// Two elements, one for each side, the lower one first.
template <class T>
struct By_side
{
  std::array<T, 2> elements;

  constexpr T& operator[](Side side) { return elements[static_cast<std::size_t>(side)]; }
  constexpr const T& operator[](Side side) const { return elements[static_cast<std::size_t>(side)]; }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_SIDE_H
