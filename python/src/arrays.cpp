// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "arrays.h"

#include <cmath>

namespace reeb_graph_python {
namespace {
using reeb_graph_program::Corner;

void check_different(const Corner* row, std::size_t columns, const char* item, std::size_t i)
{
  for(std::size_t a = 0; a + 1 < columns; ++a)
    for(std::size_t b = a + 1; b < columns; ++b)
      if(row[a] == row[b])
        throw Item_error(item, i, "has vertex " + std::to_string(row[a]) + " at two of its corners");
}

// Each number is read once only, as another thread may change it.
template <class Integer>
void copy_numbers(const py::array& array, const char* item, std::size_t number_of_vertices, Corner* out)
{
  const auto* const base = static_cast<const char*>(array.data());
  const auto rows = static_cast<std::size_t>(array.shape(0)), columns = static_cast<std::size_t>(array.shape(1));
  const py::ssize_t row_stride = array.strides(0), column_stride = array.strides(1);
  for(std::size_t i = 0; i < rows; ++i, out += columns)
  {
    const char* const row = base + static_cast<py::ssize_t>(i) * row_stride;
    for(std::size_t j = 0; j < columns; ++j)
    {
      const Integer v = *reinterpret_cast<const volatile Integer*>(row + static_cast<py::ssize_t>(j) * column_stride);
      // negative ones are large ones
      if(static_cast<std::uint64_t>(v) >= number_of_vertices)
        throw Item_error(item, i,
                         "has the vertex " + std::to_string(v) + ", but there are " + std::to_string(number_of_vertices)
                           + " vertices, numbered from 0");
      out[j] = static_cast<Corner>(v);
    }
    check_different(out, columns, item, i);
  }
}

// `allocate` is called with the number of rows, and returns where they are to be written.
template <class Allocate>
void copy_indices(const py::object& object,
                  const char* item,
                  py::ssize_t columns,
                  std::size_t number_of_vertices,
                  const Allocate& allocate)
{
  if(object.is_none())
    return;
  const auto array = py::cast<py::array>(object);
  if(array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument("an array has not the columns it should have");
  Corner* const out = allocate(static_cast<std::size_t>(array.shape(0)));
  const bool is_signed = array.dtype().kind() == 'i';
  if(array.itemsize() == 8)
    is_signed ? copy_numbers<std::int64_t>(array, item, number_of_vertices, out)
              : copy_numbers<std::uint64_t>(array, item, number_of_vertices, out);
  else if(array.itemsize() == 4)
    is_signed ? copy_numbers<std::int32_t>(array, item, number_of_vertices, out)
              : copy_numbers<std::uint32_t>(array, item, number_of_vertices, out);
  else
    throw std::invalid_argument("an array of indices is not one of 32 or 64 bits");
}

template <std::size_t n>
Corner* resize(std::vector<std::array<Corner, n>>& rows, std::size_t number)
{
  rows.resize(number);
  return rows.empty() ? nullptr : rows.front().data();
}

void copy_points(const py::object& object, std::vector<Point>& points)
{
  if(object.is_none())
    return;
  const auto array = py::cast<py::array_t<double, py::array::c_style>>(object);
  if(array.ndim() != 2 || array.shape(1) != 3 || static_cast<std::size_t>(array.shape(0)) != points.size())
    throw std::invalid_argument("the array of points has another shape");
  const volatile double* in = array.data();
  for(std::size_t i = 0; i < points.size(); ++i, in += 3)
  {
    const double x = in[0], y = in[1], z = in[2];
    if(!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      throw Item_error("vertex", i, "has a coordinate that is not a finite number");
    points[i] = Point(x, y, z);
  }
}

} // namespace

Polygon_soup copy_arrays(const Mesh_arrays& arrays, std::size_t number_of_vertices)
{
  Polygon_soup soup;
  soup.points.assign(number_of_vertices, Point(0, 0, 0));
  copy_points(arrays.points, soup.points);
  copy_indices(arrays.triangles, "triangle", 3, number_of_vertices,
               [&](std::size_t number) { return soup.polygons.make_triangles(number); });
  copy_indices(arrays.edges, "edge", 2, number_of_vertices,
               [&](std::size_t number) { return resize(soup.edges, number); });
  copy_indices(arrays.tetrahedra, "tetrahedron", 4, number_of_vertices,
               [&](std::size_t number) { return resize(soup.tetrahedra, number); });
  return soup;
}

std::vector<double> copy_values(const Value_array& values)
{
  if(values.ndim() != 1)
    throw std::invalid_argument("the array of values is not one-dimensional");
  const auto unchecked = values.unchecked<1>();
  std::vector<double> result(static_cast<std::size_t>(values.shape(0)));
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = unchecked(static_cast<py::ssize_t>(i));
  return result;
}

Value_array array_of(const std::vector<double>& numbers)
{
  return Value_array(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

Index_array array_of(const std::vector<std::size_t>& numbers)
{
  Index_array result(static_cast<py::ssize_t>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), result.mutable_data());
  return result;
}

Value_array array_of(const std::vector<Point>& points)
{
  Value_array result({points.size(), std::size_t(3)});
  double* out = result.mutable_data();
  for(const Point& p : points)
    out = std::copy_n(p.cartesian_begin(), 3, out);
  return result;
}

} // namespace reeb_graph_python
