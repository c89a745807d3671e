// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SCALAR_MAPS_H
#define CGAL_REEB_GRAPH_SCALAR_MAPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/range/size.hpp>
#include <boost/range/value_type.hpp>

#include <cstddef>
#include <iterator>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphScalarMaps
/// @{

/// \brief makes a scalar map from a range of values, one per vertex in the order of `vertices(mesh)`.
///
/// For meshes without property maps of their own, such as `Polyhedron_3`, and for values that come from elsewhere.
/// The map is a dynamic property map of \cgal that holds a copy of the values; nothing is stored in the mesh,
/// which has to outlive the map.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarRange a model of `ForwardRange`
///
/// \param mesh the mesh
/// \param values as many values as there are vertices
///
/// \pre There are as many values as vertices.
///
/// \reebGraphComplexity
///
/// \returns a model of `ReadablePropertyMap` with the vertex descriptors as key type and the values of the range as
///          value type.
///
/// \exception Scalar_count_error if the range is not as long as the range of vertices
template <class FaceListGraph, class ScalarRange>
auto make_scalar_map(const FaceListGraph& mesh, const ScalarRange& values)
{
  static_assert(internal::are_met<internal::Mesh_is_face_list_graph<FaceListGraph>>);
  typedef typename boost::range_value<const ScalarRange>::type Scalar;
  auto scalar_map = get(dynamic_vertex_property_t<Scalar>(), mesh);
  const auto vertex_range = vertices(mesh);
  const std::size_t number_of_vertices = std::distance(vertex_range.first, vertex_range.second);
  const std::size_t number_of_values = std::distance(std::begin(values), std::end(values));
  if(number_of_values != number_of_vertices)
    throw Scalar_count_error(number_of_values, number_of_vertices);
  auto value = std::begin(values);
  for(auto v = vertex_range.first; v != vertex_range.second; ++v, ++value)
    put(scalar_map, *v, *value);
  return scalar_map;
}

/// \brief makes a scalar map from a function object that is called with a vertex of `mesh`.
///
/// The function object is copied into the map and called each time a value is read.
///
/// \param mesh the mesh, of which only the type counts
/// \param function what gives the value of a vertex
///
/// \reebGraphComplexity
///
/// \returns a model of `ReadablePropertyMap` with the vertex descriptors as key type and the result of the function
///          as value type.
template <class FaceListGraph, class VertexFunction>
auto make_scalar_map_from_function([[maybe_unused]] const FaceListGraph& mesh, const VertexFunction& function)
{
  typedef typename internal::Descriptors<FaceListGraph>::vertex_descriptor vertex_descriptor;
  return boost::make_function_property_map<vertex_descriptor>(function);
}

/// \brief returns a property map from the vertices of a mesh to their positions in `vertices(mesh)`, from 0.
///
/// It serves where a mesh has no indices of its own, such as a plain `Polyhedron_3`, or where its indices have holes.
/// The mesh is only read, so that several threads may call this function for one mesh. The map holds the positions: it
/// is that of the mesh as it is now, and copies of it share them. Several threads may read it; what is not one of the mesh
/// has the greatest number of the type.
///
/// \param mesh the mesh
///
/// \reebGraphComplexity
template <class FaceListGraph>
auto make_vertex_index_map(const FaceListGraph& mesh)
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  return internal::Descriptor_numbers<vertex_descriptor, std::size_t>(CGAL::make_range(vertices(mesh)),
                                                                      num_vertices(mesh));
}

/// \brief returns a property map from the halfedges of a mesh to their positions in `halfedges(mesh)`, from 0; else as
/// `make_vertex_index_map()`.
///
/// \param mesh the mesh
///
/// \reebGraphComplexity
template <class FaceListGraph>
auto make_halfedge_index_map(const FaceListGraph& mesh)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  return internal::Descriptor_numbers<halfedge_descriptor, std::size_t>(CGAL::make_range(halfedges(mesh)),
                                                                        num_halfedges(mesh));
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SCALAR_MAPS_H
