// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_OBJECTS_H
#define CGAL_REEB_GRAPH_PYTHON_OBJECTS_H

#include "base/progress_bar.h"
#include "base/surface.h"
#include "base/threads.h"
#include "computation/Mesh_graph.h"
#include "input/Polygon_soup.h"
#include "output/output_file.h"

#include <CGAL/Reeb_graph/exceptions.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <vector>

// What the module reeb_graph._core does with objects of Python, and with the interpreter's lock.
namespace reeb_graph_python {
namespace py = pybind11;
using namespace reeb_graph_program; // NOLINT(google-build-using-namespace): it is the program with another door

typedef py::array_t<std::int64_t, py::array::c_style> Index_array;
typedef py::array_t<double, py::array::c_style> Value_array;

// Triangles, points, edges, and tetrahedra. Python has looked at all but the numbers in them: those that are there have
// as many columns as they should have, and rows; and there is a point for each vertex.
typedef std::
  tuple<std::optional<Index_array>, std::optional<Value_array>, std::optional<Index_array>, std::optional<Index_array>>
    Mesh_arrays;

// Sets the error of Python to the one of the package that has the number of what is wrong as an attribute.
inline void set_mesh_error(const std::string& message, const char* item, std::size_t number)
{
  const py::object type = py::module_::import("reeb_graph._errors").attr("MeshError");
  PyErr_SetObject(type.ptr(), type(message, item, number).ptr());
}

[[noreturn]] inline void fail(const char* item, std::size_t number, const std::string& message)
{
  set_mesh_error(item + (" " + std::to_string(number)) + " " + message, item, number);
  throw py::error_already_set();
}

// Makes an exception of C++ that of Python. The more special ones come first.
inline void translate(std::exception_ptr error)
{
  try
  {
    if(error)
      std::rethrow_exception(error);
  }
  catch(const CGAL::Reeb_graph::Vertex_error& e)
  {
    set_mesh_error(e.what(), "vertex", e.vertex());
  }
  catch(const CGAL::Reeb_graph::Face_error& e)
  {
    set_mesh_error(e.what(), "triangle", e.face());
  }
  catch(const std::runtime_error& e) // those of the library and of the program
  {
    const bool is_of_files = dynamic_cast<const std::system_error*>(&e) || dynamic_cast<const Output_error*>(&e);
    PyErr_SetString(is_of_files ? PyExc_OSError : PyExc_ValueError, e.what());
  }
}

inline void copy_indices(const Index_array& array,
                         const char* item,
                         std::size_t number_of_vertices,
                         Corner* out,
                         bool may_repeat_corners = false)
{
  const py::ssize_t rows = array.shape(0), columns = array.shape(1);
  const volatile std::int64_t* in = array.data(); // each is read once only: another thread may change it
  for(py::ssize_t i = 0; i < rows; ++i, out += columns)
    for(py::ssize_t j = 0; j < columns; ++j)
    {
      const std::int64_t v = *in++;
      if(static_cast<std::uint64_t>(v) >= number_of_vertices) // negative ones are large ones
        fail(item, i,
             "has the vertex " + std::to_string(v) + ", but there are " + std::to_string(number_of_vertices)
               + " vertices, numbered from 0");
      out[j] = static_cast<Corner>(v);
      for(py::ssize_t k = 0; k < j; ++k)
        if(out[k] == out[j] && !may_repeat_corners)
          fail(item, i, "has vertex " + std::to_string(v) + " at two of its corners");
    }
}

inline void copy_points(const Value_array& array, std::vector<Point>& points)
{
  const volatile double* in = array.data();
  for(std::size_t i = 0; i < points.size(); ++i, in += 3)
  {
    const double x = in[0], y = in[1], z = in[2];
    if(!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      fail("vertex", i, "has a coordinate that is not a finite number");
    points[i] = Point(x, y, z);
  }
}

// Copies what the arrays hold, which other threads may change, and checks the copy. Throws MeshError. Without points, all
// are the origin.
inline Polygon_soup copy_arrays(const Mesh_arrays& arrays,
                                std::size_t number_of_vertices,
                                bool may_repeat_corners = false)
{
  const auto& [triangles, points, edges, tetrahedra] = arrays;
  Polygon_soup soup;
  soup.points.assign(number_of_vertices, Point(0, 0, 0));
  if(points)
    copy_points(*points, soup.points);
  if(triangles)
    copy_indices(*triangles, "triangle", number_of_vertices, soup.polygons.make_triangles(triangles->shape(0)),
                 may_repeat_corners);
  if(edges)
  {
    soup.edges.resize(edges->shape(0));
    copy_indices(*edges, "edge", number_of_vertices, soup.edges.front().data());
  }
  if(tetrahedra)
  {
    soup.tetrahedra.resize(tetrahedra->shape(0));
    copy_indices(*tetrahedra, "tetrahedron", number_of_vertices, soup.tetrahedra.front().data());
  }
  return soup;
}

// Adds a property map, with values, which nobody can change any more, if there are any.
inline Scalar_map add_map(Surface& surface, const std::string& name, const Value_array* values)
{
  Scalar_map map = surface.add_property_map<Surface::Vertex_index, double>(name).first;
  if(values)
  {
    std::copy_n(values->data(), values->size(), map.begin());
    set_added_vertices(surface, map);
  }
  return map;
}

// The faces of the surface, or the triangles of the complex; and the points.
inline std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh)
{
  if(mesh.complex)
    return mesh.complex->triangles;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const Surface::Face_index f : mesh.surface.faces())
  {
    const Surface::Halfedge_index h = mesh.surface.halfedge(f); // leads to the first corner that was given
    triangles.push_back({mesh.surface.target(h), mesh.surface.target(mesh.surface.next(h)), mesh.surface.source(h)});
  }
  return triangles;
}

inline std::vector<Point> points_of(const Surface& surface)
{
  return {surface.points().begin(), surface.points().end()};
}

// Work without the interpreter's lock, and what other threads of Python see of it, and can do: it stops when it looks for
// that next. The number of threads that it has is 0 for one per core.
struct Run
{
  std::size_t number_of_threads = 0;
  std::atomic<double> fraction = 0;
  std::atomic<bool> is_stopped = false;

  void operator()(const std::function<void()>& work)
  {
    const py::gil_scoped_release released;
    const std::function<bool(double)> listener = [this](double part) {
      fraction = part;
      return !is_stopped;
    };
    run_with_threads(number_of_threads, [&] {
      const Progress_listener listening(listener);
      work();
    });
  }
};

// Objects of results: vectors of numbers, points, and rows of indices become arrays, others lists.
template <class Item>
py::object to_object(const Item& item)
{
  return py::cast(item);
}
py::object to_object(const Contour& contour);
template <class... Items>
py::object to_object(const std::tuple<Items...>& items);

template <std::size_t n, class Index>
py::object to_object(const std::vector<std::array<Index, n>>& rows)
{
  Index_array result({rows.size(), n});
  std::int64_t* out = result.mutable_data();
  for(const std::array<Index, n>& row : rows)
    out = std::copy_n(row.begin(), n, out);
  return result;
}

template <class Item>
py::object to_object(const std::vector<Item>& items)
{
  if constexpr(std::is_arithmetic_v<Item>)
  {
    typedef std::conditional_t<std::is_integral_v<Item>, Index_array, Value_array> Array;
    Array result(static_cast<py::ssize_t>(items.size()));
    std::copy(items.begin(), items.end(), result.mutable_data());
    return result;
  }
  else if constexpr(std::is_same_v<Item, Point>)
  {
    Value_array result({items.size(), std::size_t(3)});
    double* out = result.mutable_data();
    for(const Point& p : items)
      out = std::copy_n(p.cartesian_begin(), 3, out);
    return result;
  }
  else
  {
    py::list result;
    for(const Item& item : items)
      result.append(to_object(item));
    return result;
  }
}

template <class... Items>
py::object to_object(const std::tuple<Items...>& items)
{
  return std::apply([](const auto&... item) -> py::object { return py::make_tuple(to_object(item)...); }, items);
}

inline py::object to_object(const Contour& contour)
{
  return to_object(std::make_tuple(contour.arc, contour.value, contour.is_closed, contour.edges, contour.points,
                                   contour.polylines, contour.triangles));
}

inline py::object to_object(const Critical_set& set)
{
  return to_object(std::make_tuple(set.lower_contours, set.upper_contours, set.star, set.border_loop));
}

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_OBJECTS_H
