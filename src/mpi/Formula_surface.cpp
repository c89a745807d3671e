// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/Formula_surface.h"

#include <cmath>

namespace reeb_graph_program {
Formula_surface::Formula_surface(unsigned genus, std::uint64_t triangles) : holes_(genus), side_(2)
{
  const double cells_of_side = 5. * genus + 3; // the cells are this many times the square of the side
  side_ = std::max<Coordinate>(2, std::llround(std::sqrt(static_cast<double>(triangles) / 4 / cells_of_side)));
  width_ = side_ * (2 * holes_ + 1);
  height_ = 3 * side_;
}

Formula_surface::Row Formula_surface::row_kind(Coordinate y) const
{
  if(y == 0 || y == height_)
    return Row::END;
  if(y < side_ || y > 2 * side_)
    return Row::WHOLE;
  return y == side_ || y == 2 * side_ ? Row::HOLE_BORDER : Row::HOLES;
}

std::uint64_t Formula_surface::upper_vertices(Row row) const
{
  return static_cast<std::uint64_t>(width_ + 1 - absent_before(width_ + 1, row));
}

std::uint64_t Formula_surface::border_vertices(Row row) const
{
  return static_cast<std::uint64_t>(border_before(width_ + 1, row));
}

std::uint64_t Formula_surface::row_start(Coordinate y) const
{
  const auto vertices_of_rows = [this](Coordinate number, Row row) {
    return static_cast<std::uint64_t>(number) * (2 * upper_vertices(row) - border_vertices(row));
  };
  const auto rows_before = [y](Coordinate first, Coordinate last) {
    return std::clamp<Coordinate>(y - first, 0, last - first);
  };
  return vertices_of_rows(rows_before(0, 1) + rows_before(height_, height_ + 1), Row::END)
       + vertices_of_rows(rows_before(1, side_) + rows_before(2 * side_ + 1, height_), Row::WHOLE)
       + vertices_of_rows(rows_before(side_, side_ + 1) + rows_before(2 * side_, 2 * side_ + 1), Row::HOLE_BORDER)
       + vertices_of_rows(rows_before(side_ + 1, 2 * side_), Row::HOLES);
}

std::uint64_t Formula_surface::cell_start(Coordinate y) const
{
  const Coordinate rows_with_holes = std::clamp<Coordinate>(y - side_, 0, side_);
  return static_cast<std::uint64_t>(y * width_ - rows_with_holes * holes_ * side_);
}

Formula_surface::Coordinate Formula_surface::absent_before(Coordinate x, Row row) const
{
  if(row != Row::HOLES)
    return 0;
  Coordinate number = 0;
  for(Coordinate hole = 0; hole < holes_; ++hole)
    number += std::clamp<Coordinate>(x - (2 * hole + 1) * side_ - 1, 0, side_ - 1);
  return number;
}

Formula_surface::Coordinate Formula_surface::border_before(Coordinate x, Row row) const
{
  if(row == Row::END)
    return x;
  Coordinate number = (x > 0 ? 1 : 0) + (x > width_ ? 1 : 0);
  for(Coordinate hole = 0; hole < holes_ && row != Row::WHOLE; ++hole)
  {
    const Coordinate begin = (2 * hole + 1) * side_, end = begin + side_;
    number += row == Row::HOLE_BORDER ? std::clamp<Coordinate>(x - begin, 0, side_ + 1)
                                      : (x > begin ? 1 : 0) + (x > end ? 1 : 0);
  }
  return number;
}

bool Formula_surface::is_hole(Coordinate x, Coordinate y) const
{
  return y >= side_ && y < 2 * side_ && x / side_ % 2 == 1;
}

std::uint64_t Formula_surface::upper_vertex(Coordinate x, Coordinate y) const
{
  return row_start(y) + static_cast<std::uint64_t>(x - absent_before(x, row_kind(y)));
}

std::uint64_t Formula_surface::lower_vertex(Coordinate x, Coordinate y) const
{
  const Row row = row_kind(y);
  if(is_on_border(x, row))
    return upper_vertex(x, y);
  return row_start(y) + upper_vertices(row)
       + static_cast<std::uint64_t>(x - absent_before(x, row) - border_before(x, row));
}

// Holes are a unit apart, and the plate is rounded where it is near to a border.
Formula_surface::Point_of_formula Formula_surface::point(Coordinate x, Coordinate y, bool is_lower) const
{
  constexpr double thickness = 0.2;
  const double unit = 2. * static_cast<double>(side_);
  Coordinate distance = std::min({x, y, width_ - x, height_ - y});
  if(holes_ > 0)
  {
    // to the nearest hole, which is left or right, and below or above, of the point
    const Coordinate hole = std::clamp<Coordinate>(x / side_ - 1, 0, 2 * holes_ - 2) / 2;
    for(const Coordinate h : {hole, std::min(hole + 1, holes_ - 1)})
    {
      const Coordinate begin = (2 * h + 1) * side_;
      const Coordinate beside = std::max({begin - x, x - begin - side_, side_ - y, y - 2 * side_, Coordinate(0)});
      distance = std::min(distance, beside);
    }
  }
  const double inwards = 1 - std::min(static_cast<double>(distance) / unit / thickness, 1.);
  const double z = thickness * std::sqrt(1 - inwards * inwards);
  return {static_cast<double>(x) / unit - static_cast<double>(width_) / unit / 2,
          static_cast<double>(y) / unit - static_cast<double>(height_) / unit / 2, is_lower ? -z : z};
}

} // namespace reeb_graph_program
