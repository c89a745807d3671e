// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/tuning.h>

#include <cstdint>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Loops that jump about in memory, but know where to, tell so some rounds ahead.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  if(is_used(Tuned_part::PREFETCH))
    __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

// The place where the element of a vector is or would be that `key` names: for any key.
template <class Vector, class Key>
void prefetch_element(const Vector& vector, Key key)
{
  // Computed as a number, as a pointer must not leave its array.
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(vector.data());
  // NOLINTNEXTLINE(performance-no-int-to-ptr): nothing is read from there
  prefetch(reinterpret_cast<const void*>(begin + key.number() * sizeof(typename Vector::value_type)));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H
