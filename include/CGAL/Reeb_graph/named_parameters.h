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

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>
#include <vector>

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
