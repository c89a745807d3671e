// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_MADE_ON_DEMAND_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_MADE_ON_DEMAND_H

#include <CGAL/license/Reeb_graph.h>

#include <memory>
#include <mutex>

namespace CGAL::Reeb_graph::internal {

// A part of a constant object that is made when it is asked for first, by whichever thread that is.
template <class T>
class Made_on_demand
{
public:
  // make() is called by the first call only.
  template <class Make>
  const T& operator()(const Make& make) const
  {
    std::call_once(part_->is_made, [&] { part_->value = make(); });
    return part_->value;
  }

private:
  struct Part
  {
    std::once_flag is_made;
    T value;
  };

  std::unique_ptr<Part> part_ = std::make_unique<Part>(); // so that the object can be moved
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_MADE_ON_DEMAND_H
