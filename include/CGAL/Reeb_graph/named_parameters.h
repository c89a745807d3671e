// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
#define CGAL_REEB_GRAPH_NAMED_PARAMETERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

namespace CGAL {

namespace Reeb_graph {
namespace internal {

// The tags of the package's own parameters; everything else about them is CGAL's.
enum keep_degree_two_nodes_t { keep_degree_two_nodes };

// A parameter that may be given by value or as std::reference_wrapper.
template <class T>
T& unwrap_reference(T& parameter)
{
  return parameter;
}

template <class T>
T& unwrap_reference(std::reference_wrapper<T>& parameter)
{
  return parameter;
}

} // namespace internal
} // namespace Reeb_graph

namespace parameters {

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief starts a pack of named parameters with `keep_degree_two_nodes`, see `compute_reeb_graph()`.
inline auto keep_degree_two_nodes(bool is_kept)
{
  return Named_function_parameters<bool, Reeb_graph::internal::keep_degree_two_nodes_t>(is_kept);
}

/// \ingroup PkgReebGraphNamedParameters
///
/// \brief appends `keep_degree_two_nodes` to the pack `np`.
template <class T, class Tag, class Base>
auto keep_degree_two_nodes(bool is_kept, const Named_function_parameters<T, Tag, Base>& np)
{
  return Named_function_parameters<bool, Reeb_graph::internal::keep_degree_two_nodes_t,
                                   Named_function_parameters<T, Tag, Base>>(is_kept, np);
}

} // namespace parameters
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
