// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

template <class Traits>
using Scalar_to_double = decltype(std::declval<const Traits&>().scalar_to_double_object());
template <class Traits>
using Scalar_from_double = decltype(std::declval<const Traits&>().scalar_from_double_object());

// The way from the values of a field to numbers and back: that of the traits class, else that of number types. Values
// of any other type are not a number each.
template <class Traits>
class Scalar_conversion
{
  typedef typename Traits::Scalar Scalar;
  static constexpr bool is_given = Has<Scalar_to_double, Traits>::value;
  static constexpr bool is_number =
    std::is_arithmetic_v<Scalar> || Real_embeddable_traits<Scalar>::Is_real_embeddable::value;

public:
  // Whether each value has a number.
  static constexpr bool has_numbers = is_given || is_number;

  explicit Scalar_conversion(const Traits& traits) : traits_(traits) {}

  double to_double(const Scalar& value) const
  {
    if constexpr(is_given)
      return traits_.scalar_to_double_object()(value);
    else if constexpr(std::is_arithmetic_v<Scalar>)
      return static_cast<double>(value);
    else if constexpr(is_number)
      return CGAL::to_double(value);
    else
      return std::numeric_limits<double>::quiet_NaN();
  }

  // The value of a number between two others; if the numbers of the field fall, integers are rounded up.
  std::optional<Scalar> from_double(double number, bool is_falling) const
  {
    if constexpr(Has<Scalar_from_double, Traits>::value)
      return traits_.scalar_from_double_object()(number);
    else if constexpr(is_given)
      return std::nullopt;
    else if constexpr(std::is_integral_v<Scalar>)
      return static_cast<Scalar>(is_falling ? std::ceil(number) : std::floor(number));
    else if constexpr(is_number && std::is_constructible_v<Scalar, double>)
      return static_cast<Scalar>(number);
    else
      return std::nullopt;
  }

private:
  Traits traits_;
};

// ---- Requirements of functions that need numbers

template <class Traits>
struct Scalars_are_numbers : std::bool_constant<Scalar_conversion<Traits>::has_numbers>
{
  static_assert(
    Scalars_are_numbers::value,
    "The scalar values are not numbers, which this function needs. Pass as named parameter geom_traits, if it "
    "takes that, a traits class with a member scalar_to_double_object() that makes numbers of them.");
};

template <class Mesh, class ScalarMap, class Traits>
using Mesh_with_numbers = std::conjunction<Mesh_with_scalars<Mesh, ScalarMap>, Scalars_are_numbers<Traits>>;

template <class Mesh, class ScalarMap, class Traits>
using Field_of_numbers = std::conjunction<Scalar_field<Mesh, ScalarMap, Traits>, Scalars_are_numbers<Traits>>;

// The traits class for functions that see no more of a field than the values of the nodes: the named parameter
// geom_traits, or else one that knows their type; another type if there are none, so that only the message says so.
template <class Graph, class = void>
struct Default_traits_of_nodes
{
  typedef int Scalar;
};
template <class Graph>
struct Default_traits_of_nodes<Graph,
                               std::enable_if_t<std::conjunction_v<Has<Vertices_of, Graph>, Has<Value_of_node, Graph>>>>
{
  typedef Value_of_node<Graph> Scalar;
};

template <class Graph, class NamedParameters>
using Traits_of_nodes = Chosen_traits<Default_traits_of_nodes<Graph>, NamedParameters>;

template <class Graph, class NamedParameters>
auto choose_conversion_of_nodes(const NamedParameters& np)
{
  return Scalar_conversion<Traits_of_nodes<Graph, NamedParameters>>(choose_traits<Default_traits_of_nodes<Graph>>(np));
}

template <class Graph>
struct Nodes_have_values : Has<Value_of_node, Graph>
{
  static_assert(Nodes_have_values::value,
                "The nodes of the graph have no scalar values: their property needs a member `value`.");
};

// Values that are numbers, if need be by the named parameter geom_traits.
template <class Graph, class NamedParameters>
using Nodes_have_numbers =
  std::conjunction<Nodes_have_values<Graph>, Scalars_are_numbers<Traits_of_nodes<Graph, NamedParameters>>>;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H
