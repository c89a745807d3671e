// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_HEIGHT_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_HEIGHT_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the height of each vertex along a direction: the scalar product of the direction and the point.
///
/// The length of the direction counts. The number type is that of the points: with an exact kernel and a field map of
/// its number type, no height is rounded. It takes linear time, and works for any graph with points.
///
/// \tparam VertexListGraph a model of `VertexListGraph`
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from the number type of the points, or from `double`
/// \tparam Vector_3 the vector type of the kernel of the points
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param direction the direction
/// \param np `callback` and `vertex_point_map` as for `compute_harmonic_field()`
///
/// \reebGraphComplexity
///
/// \exception Parameter_error if the direction is zero, or not finite
/// \exception Non_finite_scalar_error if a height is infinite or NaN
/// \exception Cancelled_error if `callback` returns `false`
///
/// When one of these is thrown, `field_map` is as it was before.
template <class VertexListGraph,
          class FieldMap,
          class Vector_3,
          class NamedParameters = parameters::Default_named_parameters>
void compute_height_field(const VertexListGraph& mesh,
                          FieldMap field_map,
                          const Vector_3& direction,
                          const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Writable_vertex_map<FieldMap, VertexListGraph>>);
  const internal::Progress progress(np);
  progress.report(0);
  typedef typename boost::property_traits<FieldMap>::value_type Value;
  if(!CGAL::is_finite(direction.x()) || !CGAL::is_finite(direction.y()) || !CGAL::is_finite(direction.z())
     || (CGAL::is_zero(direction.x()) && CGAL::is_zero(direction.y()) && CGAL::is_zero(direction.z())))
    throw Parameter_error("the direction is zero, or not finite");
  const auto point_map = internal::choose_point_map(mesh, np);
  typedef std::decay_t<decltype(direction.x())> Number;
  std::vector<Number> heights;
  for(const auto v : make_range(vertices(mesh)))
  {
    const auto& p = get(point_map, v);
    heights.push_back(direction.x() * p.x() + direction.y() * p.y() + direction.z() * p.z());
    if(!CGAL::is_finite(heights.back()))
      throw Non_finite_scalar_error(heights.size() - 1);
  }
  progress.report(0.5);
  std::size_t position = 0;
  for(const auto v : make_range(vertices(mesh)))
  {
    if constexpr(std::is_constructible_v<Value, Number>)
      put(field_map, v, static_cast<Value>(heights[position++]));
    else
      put(field_map, v, static_cast<Value>(CGAL::to_double(heights[position++])));
  }
  progress.report_end();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_HEIGHT_FIELD_H
