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

// A named parameter of the package's own, as in CGAL's parameters_interface.h: its tag, a function that starts a pack
// of parameters with a value of type `Type`, and one that appends the value to a pack. Everything else about it is
// CGAL's. To be used outside of any namespace.
#define CGAL_REEB_GRAPH_NAMED_PARAMETER(name, Type)                                                                    \
  CGAL_REEB_GRAPH_NAMED_PARAMETER_TAG(name)                                                                            \
  namespace CGAL {                                                                                                     \
  namespace parameters {                                                                                               \
  inline auto name(const Type& value)                                                                                  \
  {                                                                                                                    \
    return Named_function_parameters<Type, Reeb_graph::internal::name##_t>(value);                                     \
  }                                                                                                                    \
  template <class T, class Tag, class Base>                                                                            \
  auto name(const Type& value, const Named_function_parameters<T, Tag, Base>& np)                                      \
  {                                                                                                                    \
    return Named_function_parameters<Type, Reeb_graph::internal::name##_t, std::decay_t<decltype(np)>>(value, np);     \
  }                                                                                                                    \
  }                                                                                                                    \
  }

// A named parameter whose values have any type, otherwise as above.
#define CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(name) CGAL_REEB_GRAPH_NAMED_PARAMETER_AND_TAG(name, name)

// The same with another name for the tag, if there are functions called `name`.
#define CGAL_REEB_GRAPH_NAMED_PARAMETER_AND_TAG(name, tag)                                                             \
  CGAL_REEB_GRAPH_NAMED_PARAMETER_TAG(tag)                                                                             \
  namespace CGAL {                                                                                                     \
  namespace parameters {                                                                                               \
  template <class Value>                                                                                               \
  auto name(const Value& value)                                                                                        \
  {                                                                                                                    \
    return Named_function_parameters<Value, Reeb_graph::internal::tag##_t>(value);                                     \
  }                                                                                                                    \
  template <class Value, class T, class Tag, class Base>                                                               \
  auto name(const Value& value, const Named_function_parameters<T, Tag, Base>& np)                                     \
  {                                                                                                                    \
    return Named_function_parameters<Value, Reeb_graph::internal::tag##_t, std::decay_t<decltype(np)>>(value, np);     \
  }                                                                                                                    \
  }                                                                                                                    \
  }

#define CGAL_REEB_GRAPH_NAMED_PARAMETER_TAG(name)                                                                      \
  namespace CGAL {                                                                                                     \
  namespace Reeb_graph {                                                                                               \
  namespace internal {                                                                                                 \
  enum name##_t{name};                                                                                                 \
  }                                                                                                                    \
  }                                                                                                                    \
  }

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_NAMED_PARAMETER_H
