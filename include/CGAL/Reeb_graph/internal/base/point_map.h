// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_POINT_MAP_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_POINT_MAP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The named parameter `vertex_point_map`, or the points of the mesh.
template <class FaceGraph, class NamedParameters>
auto choose_point_map(const FaceGraph& mesh, const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, mesh));
}

template <class FaceGraph, class NamedParameters>
using Point_of_mesh = typename boost::property_traits<std::decay_t<
  decltype(choose_point_map(std::declval<const FaceGraph&>(), std::declval<const NamedParameters&>()))>>::value_type;

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_POINT_MAP_H
