// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_THROWING_TRAITS_H
#define CGAL_REEB_GRAPH_TEST_THROWING_TRAITS_H

#include "graph_checks.h"
#include "mesh_builders.h"

#include <CGAL/Reeb_graph_traits.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>

// A traits class whose order throws std::runtime_error after a number of calls, which several threads can count.
struct Throwing_traits
  : CGAL::Reeb_graph_traits<mesh_builders::Surface_mesh, graph_checks::Scalar_map_of<mesh_builders::Surface_mesh>>
{
  struct Less_scalar
  {
    std::atomic<std::size_t>* number_of_calls;
    std::size_t last_call;
    bool operator()(double a, double b) const
    {
      if(++*number_of_calls > last_call)
        throw std::runtime_error("enough");
      return a < b;
    }
  };
  Less_scalar less_scalar_object() const { return less; }
  Less_scalar less;
};

#endif // CGAL_REEB_GRAPH_TEST_THROWING_TRAITS_H
