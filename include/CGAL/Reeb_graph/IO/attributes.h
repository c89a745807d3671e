// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_ATTRIBUTES_H
#define CGAL_REEB_GRAPH_IO_ATTRIBUTES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Attribute.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <cstddef>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph::internal {

inline std::size_t size_of(const Attribute& attribute)
{
  return std::visit([](const auto& numbers) { return numbers.size(); }, attribute.numbers);
}

inline void check_attributes(const std::vector<Attribute>& attributes, std::size_t size)
{
  for(const Attribute& attribute : attributes)
    if(size_of(attribute) != size)
      throw Attribute_count_error(attribute.name, size_of(attribute), size);
}

// The attributes of a named parameter, which have to be as many as things.
template <class Parameter>
std::vector<Attribute> checked_attributes(const Parameter& parameter, std::size_t size)
{
  std::vector<Attribute> attributes = parameters::choose_parameter(parameter, std::vector<Attribute>());
  check_attributes(attributes, size);
  return attributes;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_IO_ATTRIBUTES_H
