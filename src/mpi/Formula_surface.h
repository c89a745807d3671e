// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FORMULA_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_FORMULA_SURFACE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace reeb_graph_program {
// A closed surface of which any part can be made without the rest: a plate with `genus` square holes in a row, meshed
// by a lattice, twice, where the upper and the lower side share the vertices on the border. Cells have four triangles:
// two on either side.
class Formula_surface
{
public:
  typedef std::array<double, 3> Point_of_formula;
  typedef std::array<std::uint64_t, 3> Triangle;

  // `triangles` is right up to the size of the lattice; there are 48 (genus 0) or more.
  Formula_surface(unsigned genus, std::uint64_t triangles);

  std::uint64_t number_of_vertices() const { return row_start(height_ + 1); }
  std::uint64_t number_of_cells() const { return cell_start(height_); }
  std::uint64_t number_of_triangles() const { return 4 * number_of_cells(); }

  // Calls the function with the point of each vertex from `first` to before `last`, in their order.
  template <class Function>
  void for_each_point(std::uint64_t first, std::uint64_t last, const Function& function) const;

  // Calls the function with each triangle of the cells from `first` to before `last`, in their order.
  template <class Function>
  void for_each_triangle(std::uint64_t first, std::uint64_t last, const Function& function) const;

private:
  typedef std::int64_t Coordinate;

  // Rows of vertices are at the border of the plate, beside holes, at the border of holes, or through them.
  enum class Row
  {
    END,
    WHOLE,
    HOLE_BORDER,
    HOLES
  };
  Row row_kind(Coordinate y) const;

  std::uint64_t upper_vertices(Row row) const; // in a row
  std::uint64_t border_vertices(Row row) const;
  std::uint64_t row_start(Coordinate y) const;  // the first vertex of a row
  std::uint64_t cell_start(Coordinate y) const; // the first cell of a row

  // How many vertices of the row are before x: none is there, or it is on the border.
  Coordinate absent_before(Coordinate x, Row row) const;
  Coordinate border_before(Coordinate x, Row row) const;
  bool is_absent(Coordinate x, Row row) const { return absent_before(x + 1, row) > absent_before(x, row); }
  bool is_on_border(Coordinate x, Row row) const { return border_before(x + 1, row) > border_before(x, row); }
  bool is_hole(Coordinate x, Coordinate y) const; // a cell

  std::uint64_t upper_vertex(Coordinate x, Coordinate y) const;
  std::uint64_t lower_vertex(Coordinate x, Coordinate y) const;
  Point_of_formula point(Coordinate x, Coordinate y, bool is_lower) const;

  // The row with the index, where the function gives the first index of each row.
  template <class Start>
  Coordinate row_of(std::uint64_t index, Coordinate number_of_rows, const Start& start) const;

  Coordinate holes_;
  Coordinate side_; // of a hole, of the plate beside it, and between two of them
  Coordinate width_, height_;
};

template <class Start>
Formula_surface::Coordinate Formula_surface::row_of(std::uint64_t index,
                                                    Coordinate number_of_rows,
                                                    const Start& start) const
{
  Coordinate low = 0, high = number_of_rows; // the row is from low to before high
  while(high - low > 1)
  {
    const Coordinate middle = low + (high - low) / 2;
    (start(middle) <= index ? low : high) = middle;
  }
  return low;
}

template <class Function>
void Formula_surface::for_each_point(std::uint64_t first, std::uint64_t last, const Function& function) const
{
  if(first >= last)
    return;
  Coordinate y = row_of(first, height_ + 1, [this](Coordinate row) { return row_start(row); });
  for(std::uint64_t index = row_start(y); index < last; ++y)
  {
    const Row row = row_kind(y);
    for(const bool is_lower : {false, true})
      for(Coordinate x = 0; x <= width_ && index < last; ++x)
        if(!is_absent(x, row) && !(is_lower && is_on_border(x, row)))
        {
          if(index >= first)
            function(point(x, y, is_lower));
          ++index;
        }
  }
}

template <class Function>
void Formula_surface::for_each_triangle(std::uint64_t first, std::uint64_t last, const Function& function) const
{
  if(first >= last)
    return;
  Coordinate y = row_of(first, height_, [this](Coordinate row) { return cell_start(row); });
  for(std::uint64_t index = cell_start(y); index < last; ++y)
    for(Coordinate x = 0; x < width_ && index < last; ++x)
    {
      if(is_hole(x, y) || index++ < first)
        continue;
      // the diagonal ends at the corner of the plate, so that it has not both ends on the border
      const bool is_rising = (2 * x < width_) == (2 * y < height_);
      for(const bool is_lower : {false, true})
      {
        const auto vertex = [&](Coordinate u, Coordinate v) {
          return is_lower ? lower_vertex(u, v) : upper_vertex(u, v);
        };
        const std::uint64_t a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x, y + 1), d = vertex(x + 1, y + 1);
        Triangle low = is_rising ? Triangle{a, b, d} : Triangle{a, b, c};
        Triangle high = is_rising ? Triangle{a, d, c} : Triangle{b, d, c};
        if(is_lower)
        {
          std::swap(low[1], low[2]);
          std::swap(high[1], high[2]);
        }
        function(low);
        function(high);
      }
    }
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FORMULA_SURFACE_H
