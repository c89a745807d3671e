// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_NAMED_PARAMETER_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_NAMED_PARAMETER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether get_parameter() has found a named parameter, by the type that it returns.
template <class Parameter>
inline constexpr bool is_given = !std::is_same_v<std::decay_t<Parameter>, internal_np::Param_not_found>;

// Whether an argument is a sequence of named parameters.
template <class T, class Tag, class Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

template <class T>
inline constexpr bool are_named_parameters = decltype(test_named_parameters(std::declval<const T*>()))::value;

// The traits class: the named parameter geom_traits, or else the default.
template <class Default, class NamedParameters>
auto choose_traits(const NamedParameters& np)
{
  return parameters::choose_parameter<Default>(parameters::get_parameter(np, internal_np::geom_traits));
}

template <class Default, class NamedParameters>
using Chosen_traits = decltype(choose_traits<Default>(std::declval<const NamedParameters&>()));

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
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_NAMED_PARAMETER_H
