// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Tuned_part.h>

#include <cstdint>

namespace CGAL::Reeb_graph::internal {

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

// Has g++ keep a function that does nothing but fetch: it takes it to have no effect, and leaves out calls of it.
inline void keep_fetching()
{
#ifdef __GNUC__
  __asm__ volatile("");
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_PREFETCH_H
