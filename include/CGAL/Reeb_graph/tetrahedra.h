// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TETRAHEDRA_H
#define CGAL_REEB_GRAPH_TETRAHEDRA_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphRef
///
/// \brief tetrahedra by the numbers of their vertices, as `compute_reeb_graph_of_tetrahedra()` takes them, with the
/// vertices of the data structure from which they are.
///
/// \tparam VertexHandle the type of the vertices of the data structure: handles or descriptors
/// \tparam Point_ a point type
template <class VertexHandle, class Point_>
struct Tetrahedra
{
  typedef VertexHandle Vertex_handle; ///< the type of the vertices
  typedef Point_ Point;               ///< the type of the points

  /// the points of the vertices, by their numbers
  std::vector<Point> points;
  /// the numbers of the four vertices of each tetrahedron
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  /// the vertices by their numbers: leads from a node of the graph, and from a chain, back to the data structure
  std::vector<Vertex_handle> vertices;

  /// returns the values of a scalar field by the numbers of the vertices.
  ///
  /// \tparam ScalarMap a model of `ReadablePropertyMap` with `Vertex_handle` as key type
  template <class ScalarMap>
  std::vector<typename boost::property_traits<ScalarMap>::value_type> scalars(ScalarMap scalar_map) const
  {
    std::vector<typename boost::property_traits<ScalarMap>::value_type> result;
    result.reserve(vertices.size());
    for(const Vertex_handle& v : vertices)
      result.push_back(get(scalar_map, v));
    return result;
  }
};

namespace internal {

// Numbers vertices in the order in which they are added. point(vertex) returns the point of one.
template <class VertexHandle, class PointFunction>
class Tetrahedra_builder
{
  typedef Tetrahedra<VertexHandle, std::decay_t<std::invoke_result_t<PointFunction, VertexHandle>>> Result;

public:
  explicit Tetrahedra_builder(const PointFunction& point) : point_(point) {}

  std::size_t add_vertex(const VertexHandle& v)
  {
    const auto found = numbers_.emplace(v, result_.vertices.size());
    if(found.second)
    {
      result_.vertices.push_back(v);
      result_.points.push_back(point_(v));
    }
    return found.first->second;
  }

  template <class CellHandle>
  void add_cell(const CellHandle& cell)
  {
    add_tetrahedron({add_vertex(cell->vertex(0)), add_vertex(cell->vertex(1)), add_vertex(cell->vertex(2)),
                     add_vertex(cell->vertex(3))});
  }

  void add_tetrahedron(const std::array<std::size_t, 4>& tetrahedron) { result_.tetrahedra.push_back(tetrahedron); }

  Result result() && { return std::move(result_); }

private:
  PointFunction point_;
  Result result_;
  std::unordered_map<VertexHandle, std::size_t> numbers_;
};

// Points of weighted triangulations come without their weights.
template <class Triangulation>
auto make_tetrahedra_builder(const Triangulation& triangulation)
{
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  const auto point = [&triangulation](const Vertex_handle& v) {
    const auto bare_point = triangulation.geom_traits().construct_point_3_object();
    return std::decay_t<decltype(bare_point(v->point()))>(bare_point(v->point()));
  };
  return Tetrahedra_builder<Vertex_handle, decltype(point)>(point);
}

} // namespace internal

/// \ingroup PkgReebGraphRef
///
/// \brief returns the finite cells of a triangulation.
///
/// The vertices are all finite ones, in the order of `triangulation.finite_vertices_begin()`, and the tetrahedra are in
/// that of `triangulation.finite_cells_begin()`. A triangulation of dimension less than 3 has no tetrahedra.
/// This takes linear time.
///
/// \tparam Triangulation a `CGAL::Triangulation_3`, or a class derived from it, weighted or not, whose geometric traits
///         have `Construct_point_3`, as the kernels of \cgal do
///
/// \param triangulation the triangulation
///
/// \reebGraphComplexity
///
/// \returns the `Tetrahedra`.
template <class Triangulation>
auto tetrahedra_of_triangulation(const Triangulation& triangulation)
{
  auto builder = internal::make_tetrahedra_builder(triangulation);
  for(auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
    builder.add_vertex(v);
  if(triangulation.dimension() == 3)
    for(auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell)
      builder.add_cell(cell);
  return std::move(builder).result();
}

/// \ingroup PkgReebGraphRef
///
/// \brief returns the cells of a 3D complex in a triangulation, such as `CGAL::make_mesh_3()` returns it.
///
/// The tetrahedra are in the order of `complex.cells_in_complex_begin()`. The vertices are theirs only, in the order in
/// which they occur. This takes linear time.
///
/// \tparam MeshComplex a model of `MeshComplex_3InTriangulation_3`, such as `CGAL::Mesh_complex_3_in_triangulation_3`
///
/// \param complex the complex
///
/// \reebGraphComplexity
///
/// \returns the `Tetrahedra`.
template <class MeshComplex>
auto tetrahedra_of_complex(const MeshComplex& complex)
{
  auto builder = internal::make_tetrahedra_builder(complex.triangulation());
  for(auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
    builder.add_cell(cell);
  return std::move(builder).result();
}

/// \ingroup PkgReebGraphRef
///
/// \brief returns the 3-cells of a linear cell complex, which have to be tetrahedra.
///
/// The vertices are all vertex attributes, in the order of `complex.vertex_attributes()`. The tetrahedra are in that of
/// `complex.one_dart_per_cell<3>()`. With \f$ n \f$ darts this takes \f$ O(n) \f$ time.
///
/// \tparam LinearCellComplex a model of `LinearCellComplex` of dimension 3, such as
///         `CGAL::Linear_cell_complex_for_combinatorial_map<3>`, whose vertex attributes can be hashed by `std::hash`
///
/// \param complex the linear cell complex
///
/// \reebGraphComplexity
///
/// \returns the `Tetrahedra`.
///
/// \exception Non_tetrahedral_cell_error if a 3-cell is not a tetrahedron, or one with a vertex at two of its corners
template <class LinearCellComplex>
auto tetrahedra_of_linear_cell_complex(const LinearCellComplex& complex)
{
  typedef std::decay_t<decltype(complex.vertex_attribute(complex.darts().begin()))> Vertex_handle;
  static_assert(LinearCellComplex::dimension == 3, "the linear cell complex has to be of dimension 3");
  const auto point = [&](const Vertex_handle& v) { return complex.point_of_vertex_attribute(v); };
  internal::Tetrahedra_builder<Vertex_handle, decltype(point)> builder(point);
  for(auto v = complex.vertex_attributes().begin(); v != complex.vertex_attributes().end(); ++v)
    builder.add_vertex(v);
  std::size_t number_of_cells = 0;
  const auto cells = complex.template one_dart_per_cell<3>();
  for(auto dart = cells.begin(); dart != cells.end(); ++dart, ++number_of_cells)
  {
    if(!complex.is_volume_combinatorial_tetrahedron(dart))
      throw Non_tetrahedral_cell_error(number_of_cells);
    std::array<std::size_t, 4> tetrahedron = {};
    std::size_t i = 0;
    const auto corners = complex.template one_dart_per_incident_cell<0, 3>(dart);
    for(auto corner = corners.begin(); corner != corners.end() && i < 4; ++corner)
      tetrahedron[i++] = builder.add_vertex(complex.vertex_attribute(corner));
    if(i < 4)
      throw Non_tetrahedral_cell_error(number_of_cells);
    builder.add_tetrahedron(tetrahedron);
  }
  return std::move(builder).result();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_TETRAHEDRA_H
