// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_ARRAYS_H
#define CGAL_REEB_GRAPH_PYTHON_ARRAYS_H

#include "base/complex.h"
#include "computation/contours.h"
#include "input/Polygon_soup.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace reeb_graph_python {
namespace py = pybind11;
using namespace reeb_graph_program; // NOLINT(google-build-using-namespace): it is the program with another door

typedef py::array_t<std::int64_t> Index_array;
typedef py::array_t<double, py::array::c_style> Value_array;

// What is wrong with an array, and the number of its item: a vertex, triangle, edge, or tetrahedron.
struct Item_error : std::runtime_error
{
  Item_error(const std::string& item, std::size_t number, const std::string& message)
    : std::runtime_error(item + " " + std::to_string(number) + " " + message),
      item(item),
      number(number)
  {}

  std::string item;
  std::size_t number;
};

// The arrays of a mesh, as Python has prepared them: each is none, or has so many columns of integers of 64 bits, or of
// doubles.
struct Mesh_arrays
{
  py::object triangles, points, edges, tetrahedra;
};

// Copies what the arrays hold, which other threads may change afterwards, and checks it as it is copied. Throws
// Item_error. Without points, all are the origin.
Polygon_soup copy_arrays(const Mesh_arrays& arrays, std::size_t number_of_vertices);

// One value for each vertex. An array that can be written is copied, as another thread may do so; another one is kept.
class Values
{
public:
  Values() = default;
  explicit Values(const Value_array& array);

  std::size_t size() const { return size_; }

  // Adds a property map with the values.
  Scalar_map add_to(Surface& surface, const std::string& name) const;

private:
  std::shared_ptr<const void> owner_;
  const double* data_ = nullptr;
  std::size_t size_ = 0;
};

// The faces of the surface, or the triangles of the complex; and the points.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh);
std::vector<Point> points_of(const Surface& surface);

// Objects of results: vectors of numbers, points, and rows of indices become arrays, others lists.
py::object to_object(const Contour& contour);
py::object to_object(const Critical_set& set);
inline py::object to_object(const std::string& text) { return py::str(text); }
template <class... Items>
py::object to_object(const std::tuple<Items...>& items);

template <std::size_t n, class Index>
py::object to_object(const std::vector<std::array<Index, n>>& rows)
{
  Index_array result({rows.size(), n});
  std::int64_t* out = result.mutable_data();
  for(const std::array<Index, n>& row : rows)
    for(const Index i : row)
      *out++ = static_cast<std::int64_t>(i);
  return std::move(result);
}

template <class Item>
py::object to_object(const std::vector<Item>& items)
{
  if constexpr(std::is_arithmetic_v<Item>)
  {
    typedef std::conditional_t<std::is_integral_v<Item>, Index_array, Value_array> Array;
    Array result(static_cast<py::ssize_t>(items.size()));
    std::copy(items.begin(), items.end(), result.mutable_data());
    return std::move(result);
  }
  else if constexpr(std::is_same_v<Item, Point>)
  {
    Value_array result({items.size(), std::size_t(3)});
    double* out = result.mutable_data();
    for(const Point& p : items)
      out = std::copy_n(p.cartesian_begin(), 3, out);
    return std::move(result);
  }
  else
  {
    py::list result;
    for(const Item& item : items)
      result.append(to_object(item));
    return std::move(result);
  }
}

template <class... Items>
py::object to_object(const std::tuple<Items...>& items)
{
  return std::apply([](const auto&... item) -> py::object { return py::make_tuple(to_object(item)...); }, items);
}

// Adds the functions that compute fields, and those that cut along curves.
void add_functions(py::module_& module);

// Makes exceptions of C++ those of Python.
void translate_exceptions();

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_ARRAYS_H
