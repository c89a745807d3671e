// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "arrays.h"

#include <algorithm>
#include <cmath>

namespace reeb_graph_python {
namespace {
void check_different(const Corner* row, std::size_t columns, const char* item, std::size_t i)
{
  for(std::size_t a = 0; a + 1 < columns; ++a)
    for(std::size_t b = a + 1; b < columns; ++b)
      if(row[a] == row[b])
        throw Item_error(item, i, "has vertex " + std::to_string(row[a]) + " at two of its corners");
}

// `allocate` is called with the number of rows, and returns where they are to be written. Each number is read once only,
// as another thread may change it.
template <class Allocate>
void copy_indices(const py::object& object,
                  const char* item,
                  std::size_t columns,
                  std::size_t number_of_vertices,
                  const Allocate& allocate)
{
  if(object.is_none())
    return;
  const auto array = py::cast<py::array_t<std::int64_t, py::array::c_style>>(object);
  if(array.ndim() != 2 || static_cast<std::size_t>(array.shape(1)) != columns)
    throw std::invalid_argument("an array has not the columns it should have");
  const auto rows = static_cast<std::size_t>(array.shape(0));
  const volatile std::int64_t* in = array.data();
  Corner* out = allocate(rows);
  for(std::size_t i = 0; i < rows; ++i, out += columns)
  {
    for(std::size_t j = 0; j < columns; ++j)
    {
      const std::int64_t v = *in++;
      if(static_cast<std::uint64_t>(v) >= number_of_vertices) // negative ones are large ones
        throw Item_error(item, i,
                         "has the vertex " + std::to_string(v) + ", but there are " + std::to_string(number_of_vertices)
                           + " vertices, numbered from 0");
      out[j] = static_cast<Corner>(v);
    }
    check_different(out, columns, item, i);
  }
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

Values::Values(const Value_array& array) : size_(static_cast<std::size_t>(array.size()))
{
  if(array.ndim() != 1)
    throw std::invalid_argument("the array of values is not one-dimensional");
  if(array.writeable())
  {
    const auto copy = std::make_shared<std::vector<double>>(array.data(), array.data() + size_);
    data_ = copy->data();
    owner_ = copy;
    return;
  }
  data_ = array.data();
  owner_.reset(new py::object(array), [](const py::object* object) { // in any thread
    const py::gil_scoped_acquire acquired;
    delete object;
  });
}

Scalar_map Values::add_to(Surface& surface, const std::string& name) const
{
  Scalar_map map = surface.add_property_map<Surface::Vertex_index, double>(name).first;
  if(size_ > 0)
    std::copy_n(data_, size_, &map[Surface::Vertex_index(0)]);
  return map;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh)
{
  if(mesh.complex)
    return mesh.complex->triangles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const Surface::Face_index f : mesh.surface.faces())
  {
    const Surface::Halfedge_index h = mesh.surface.halfedge(f);
    triangles.push_back({mesh.surface.source(h), mesh.surface.target(h), mesh.surface.target(mesh.surface.next(h))});
  }
  return triangles;
}

std::vector<Point> points_of(const Surface& surface) { return {surface.points().begin(), surface.points().end()}; }

py::object to_object(const Contour& contour)
{
  return py::dict(py::arg("arc") = contour.arc, py::arg("value") = contour.value, py::arg("closed") = contour.is_closed,
                  py::arg("edges") = to_object(contour.edges), py::arg("points") = to_object(contour.points),
                  py::arg("polylines") = to_object(contour.polylines),
                  py::arg("triangles") = to_object(contour.triangles));
}

py::object to_object(const Critical_set& set)
{
  return to_object(std::make_tuple(set.lower_contours, set.upper_contours, set.star, set.border_loop));
}

} // namespace reeb_graph_python
