// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTOR_NUMBERS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTOR_NUMBERS_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <unordered_map>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The descriptors of a mesh, numbered in the order in which they are added: a property map whose copies share the
// numbers. Several threads may read it, also with descriptors of other meshes, which a dynamic property map of CGAL
// inserts when it is read.
template <class Descriptor, class Number>
class Descriptor_numbers
{
public:
  typedef Descriptor key_type;
  typedef Number value_type;
  typedef Number reference;
  typedef boost::readable_property_map_tag category;

  explicit Descriptor_numbers(std::size_t size) : numbers_(std::make_shared<std::unordered_map<Descriptor, Number>>())
  {
    numbers_->reserve(size);
  }

  void add(const Descriptor& d) { numbers_->emplace(d, static_cast<Number>(numbers_->size())); }

  // The number of a descriptor, the greatest of its type if it has none.
  friend Number get(const Descriptor_numbers& map, const Descriptor& d)
  {
    const auto found = map.numbers_->find(d);
    return found == map.numbers_->end() ? (std::numeric_limits<Number>::max)() : found->second;
  }

private:
  std::shared_ptr<std::unordered_map<Descriptor, Number>> numbers_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTOR_NUMBERS_H
