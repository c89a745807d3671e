// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
#define CGAL_REEB_GRAPH_NAMED_PARAMETERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// Whether get_parameter() has found a named parameter, by the type that it returns.
template <class Parameter>
inline constexpr bool is_given = !std::is_same_v<std::decay_t<Parameter>, internal_np::Param_not_found>;

// Whether an argument is a sequence of named parameters.
template <class T, class Tag, class Base>
std::true_type test_named_parameters(const Named_function_parameters<T, Tag, Base>*);
std::false_type test_named_parameters(const void*);

template <class T>
inline constexpr bool are_named_parameters = decltype(test_named_parameters(std::declval<const T*>()))::value;

// The named parameter, or else the default.
template <class NamedParameters, class Tag, class Default>
auto parameter_or(const NamedParameters& np, Tag tag, const Default& default_value)
{
  return parameters::choose_parameter(parameters::get_parameter(np, tag), default_value);
}

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

// The named parameter `vertex_point_map`, or the points of the mesh.
template <class FaceGraph, class NamedParameters>
auto choose_point_map(const FaceGraph& mesh, const NamedParameters& np)
{
  return parameter_or(np, internal_np::vertex_point, get_const_property_map(CGAL::vertex_point, mesh));
}

template <class FaceGraph, class NamedParameters>
using Point_of_mesh = typename boost::property_traits<std::decay_t<
  decltype(choose_point_map(std::declval<const FaceGraph&>(), std::declval<const NamedParameters&>()))>>::value_type;

} // namespace CGAL::Reeb_graph::internal

// The named parameters of the package's own; their documentation is in the list `PkgReebGraphNamedParameters`.

namespace CGAL {
namespace Reeb_graph {

namespace internal {

// the tags
#define CGAL_REEB_GRAPH_NAMED_PARAMETER(name, Type) enum name##_t{name};
#define CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(name, tag) enum tag##_t{tag};
#include <CGAL/Reeb_graph/internal/base/named_parameters_list.h>
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE

// A sequence of named parameters that ends with one of the package's own. All of these can follow, and those of CGAL.
// Behind one of CGAL's come no others than CGAL's: its sequences are bases of this one, but not this one of theirs.
template <class T, class Tag, class Base = internal_np::No_property>
struct Reeb_parameters : Named_function_parameters<T, Tag, Base>
{
  typedef Named_function_parameters<T, Tag, Base> Sequence;
  using Sequence::Sequence;

#define CGAL_REEB_GRAPH_NAMED_PARAMETER(name, Type)                                                                    \
  auto name(const Type& value) const { return Reeb_parameters<Type, name##_t, Sequence>(value, *this); }
#define CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(name, tag)                                                         \
  template <class Value>                                                                                               \
  auto name(const Value& value) const                                                                                  \
  {                                                                                                                    \
    return Reeb_parameters<Value, tag##_t, Sequence>(value, *this);                                                    \
  }
#include <CGAL/Reeb_graph/internal/base/named_parameters_list.h>
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE
};

} // namespace internal
} // namespace Reeb_graph

namespace parameters {

// For each parameter, a function that starts a sequence.
#define CGAL_REEB_GRAPH_NAMED_PARAMETER(name, Type)                                                                    \
  inline auto name(const Type& value)                                                                                  \
  {                                                                                                                    \
    return Reeb_graph::internal::Reeb_parameters<Type, Reeb_graph::internal::name##_t>(value);                         \
  }
#define CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(name, tag)                                                         \
  template <class Value>                                                                                               \
  auto name(const Value& value)                                                                                        \
  {                                                                                                                    \
    return Reeb_graph::internal::Reeb_parameters<Value, Reeb_graph::internal::tag##_t>(value);                         \
  }
#include <CGAL/Reeb_graph/internal/base/named_parameters_list.h>
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER
#undef CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE

} // namespace parameters
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
