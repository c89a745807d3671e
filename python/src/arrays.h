// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_ARRAYS_H
#define CGAL_REEB_GRAPH_PYTHON_ARRAYS_H

#include "base/surface.h"
#include "input/Polygon_soup.h"

#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_python {
namespace py = pybind11;
using reeb_graph_program::Point;
using reeb_graph_program::Polygon_soup;

typedef py::array_t<std::int64_t> Index_array;
typedef py::array_t<double> Value_array;

// What is wrong with an array, and the number of its item: a vertex, triangle, edge, or tetrahedron.
class Item_error : public std::runtime_error
{
public:
  Item_error(const std::string& item, std::size_t number, const std::string& message)
    : std::runtime_error(item + " " + std::to_string(number) + " " + message),
      item_(item),
      number_(number)
  {}

  const std::string& item() const { return item_; }
  std::size_t number() const { return number_; }

private:
  std::string item_;
  std::size_t number_;
};

// The arrays of a mesh, as Python has prepared them: each is none, or has so many columns of integers of 32 or 64 bits,
// or of doubles.
struct Mesh_arrays
{
  py::object triangles, points, edges, tetrahedra;
};

// Copies what the arrays hold, which other threads may change afterwards, and checks it as it is copied. Throws
// Item_error. Without points, all are the origin.
Polygon_soup copy_arrays(const Mesh_arrays& arrays, std::size_t number_of_vertices);

// Copies one value per vertex.
std::vector<double> copy_values(const Value_array& values);

// Arrays of results.
Value_array array_of(const std::vector<double>& numbers);
Index_array array_of(const std::vector<std::size_t>& numbers);
Value_array array_of(const std::vector<Point>& points);

template <std::size_t n, class Index>
Index_array array_of(const std::vector<std::array<Index, n>>& rows)
{
  Index_array result({rows.size(), n});
  std::int64_t* out = result.mutable_data();
  for(const std::array<Index, n>& row : rows)
    for(const Index i : row)
      *out++ = static_cast<std::int64_t>(i);
  return result;
}

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_ARRAYS_H
