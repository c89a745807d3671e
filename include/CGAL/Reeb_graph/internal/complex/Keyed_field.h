// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_KEYED_FIELD_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_KEYED_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Whether values are their own keys: doubles hold all numbers of the type, and their order is `<` or `>`.
template <class Scalar, class Less>
inline constexpr bool has_exact_keys =
  is_order_of_numbers<Scalar, Less>&& std::numeric_limits<Scalar>::digits <= std::numeric_limits<double>::digits;

// Whether the keys of such values are negated.
template <class Scalar, class Less>
inline constexpr bool is_falling = is_one_of<Less, std::greater<Scalar>, std::greater<>>;

// The key of a value that is its own.
template <class Less, class Scalar>
double exact_key(const Scalar& value)
{
  return is_falling<Scalar, Less> ? -static_cast<double>(value) : static_cast<double>(value);
}

// The field of a user, of any type and in any order, as the stages see it: by keys, and the way from keys to values and
// back. Values that are not their own keys have their ranks as keys, which are the same where neither value is less.
template <class Scalar>
class Keyed_field
{
public:
  // A built-in number, or a reference to any other value.
  typedef std::conditional_t<std::is_arithmetic_v<Scalar>, Scalar, const Scalar&> reference;

  Keyed_field() = default;

  // A field whose values are their own keys.
  Keyed_field(Vertex_keys keys, bool are_negated) : keys_(std::move(keys)), are_negated_(are_negated) {}

  // A field whose values are ranked, by one sort, which stays inside of the range whatever the order is. Throws if the
  // order is seen to contradict itself; if not, the ranks are an order all the same. `vertices` is a Vertex_list.
  template <class VertexList, class Less>
  Keyed_field(const VertexList& vertices, Indexed_vector<Vertex_index, Scalar> values, const Less& less)
    : keys_(values.size(), 0),
      values_(std::move(values))
  {
    struct Ranked
    {
      Scalar value;
      Vertex_index vertex;
    };
    std::vector<Ranked> sorted;
    sorted.reserve(values_.size());
    for(const Vertex_index v : values_.keys())
      if(vertices.contains(v))
        sorted.push_back({values_[v], v});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Ranked& a, const Ranked& b) { return less(a.value, b.value); });
    const Ranked *first = sorted.data(), *last = first; // of those that have the last rank
    for(const Ranked& ranked : sorted)
    {
      const bool is_higher = less(last->value, ranked.value);
      const bool is_first_the_same =
        first == last || (less(first->value, ranked.value) == is_higher && !less(ranked.value, first->value));
      if(less(ranked.value, last->value) || !is_first_the_same)
        throw Unordered_scalar_error::contradiction_near(vertices.position(ranked.vertex));
      last = &ranked;
      if(is_higher)
        first = last;
      if(first == last)
        first_vertices_.push_back(ranked.vertex);
      keys_[ranked.vertex] = static_cast<double>(first_vertices_.size() - 1);
    }
  }

  const Vertex_keys& keys() const { return keys_; }

  reference value(Vertex_index v) const
  {
    if constexpr(std::is_arithmetic_v<Scalar>)
      if(values_.empty())
        return static_cast<Scalar>(are_negated_ ? -keys_[v] : keys_[v]);
    return values_[v];
  }

  // The key that any value has in the order of the field: between those of its neighbors if no vertex has the value, NaN
  // if it has no place.
  template <class Less>
  double key_of(const Scalar& value, const Less& less) const
  {
    if(!is_ordered(value))
      return std::numeric_limits<double>::quiet_NaN();
    if constexpr(has_exact_keys<Scalar, Less>)
      return exact_key<Less>(value);
    else
    {
      const auto place = std::partition_point(first_vertices_.begin(), first_vertices_.end(),
                                              [&](Vertex_index v) { return less(values_[v], value); });
      const bool is_there = place != first_vertices_.end() && !less(value, values_[*place]);
      return static_cast<double>(place - first_vertices_.begin()) - (is_there ? 0 : 0.5);
    }
  }

  // Whether the keys are in this order.
  template <class Less>
  bool fits_order(const Less& less) const
  {
    if constexpr(has_exact_keys<Scalar, Less>)
      return values_.empty() && are_negated_ == is_falling<Scalar, Less>;
    const auto is_out_of_order = [&](Vertex_index u, Vertex_index v) { return !less(values_[u], values_[v]); };
    return values_.size() == keys_.size()
        && std::adjacent_find(first_vertices_.begin(), first_vertices_.end(), is_out_of_order) == first_vertices_.end();
  }

private:
  Vertex_keys keys_;
  bool are_negated_ = false;
  // Of ranked values only:
  Indexed_vector<Vertex_index, Scalar> values_;
  Plain_vector<Vertex_index> first_vertices_; // one of each rank
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_KEYED_FIELD_H
